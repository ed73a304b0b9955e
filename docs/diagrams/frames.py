#!/usr/bin/env python3
"""frames.py FILE.svg: draws the frames of a cell: the sheet (world), the base, a row of the arm, the tip rigid and deflected."""
import math
import sys

INK, RIGID, BENT, PALE = "#333333", "#8a8f98", "#1f5fa8", "#d9e2ee"
parts = []


def line(points, colour, width, dash=""):
    path = " ".join(f"{x:.1f},{y:.1f}" for x, y in points)
    parts.append(f'<polyline points="{path}" fill="none" stroke="{colour}" stroke-width="{width}" stroke-linejoin="round" '
                 f'stroke-linecap="round"{f" stroke-dasharray={chr(34)}{dash}{chr(34)}" if dash else ""}/>')


def text(x, y, words, size=13, colour=INK, anchor="start"):
    parts.append(f'<text x="{x:.1f}" y="{y:.1f}" font-size="{size}" fill="{colour}" text-anchor="{anchor}">{words}</text>')


def arrow(x, y, angle, length, name, colour):
    """Draws an arrow of `length` from (x, y) with its `name`; `angle` [deg] is measured counter-clockwise from the
    right."""
    a = math.radians(angle)
    tip = (x + length * math.cos(a), y - length * math.sin(a))
    line([(x, y), tip], colour, 2)
    for turn in (150, -150):
        b = a + math.radians(turn)
        line([tip, (tip[0] + 7 * math.cos(b), tip[1] - 7 * math.sin(b))], colour, 2)
    text(tip[0] + 10 * math.cos(a), tip[1] - 10 * math.sin(a) + 4, name, 11, colour, "middle")


def frame(x, y, angle, name, dx, dy, colour=INK):
    arrow(x, y, angle, 34, "x", colour)
    arrow(x, y, angle + 90, 34, "z", colour)
    parts.append(f'<circle cx="{x}" cy="{y}" r="3.5" fill="{colour}"/>')
    text(x + dx, y + dy, name, 15, colour)


def main(path):
    parts.append('<rect width="760" height="400" fill="white"/>')
    # The tube sheet with its holes, seen from the side; the arm enters them from below.
    parts.append(f'<rect x="60" y="60" width="660" height="34" fill="{PALE}" stroke="{RIGID}"/>')
    for k in range(15):
        parts.append(f'<rect x="{90 + 42 * k}" y="60" width="14" height="34" fill="white" stroke="{RIGID}" stroke-width="0.8"/>')
    text(715, 52, "tube sheet", 12, RIGID, "end")
    base, elbow, wrist = (140, 330), (320, 226), (559, 196)
    rigid_tip, bent_tip = (559, 94), (567, 122)
    parts.append(f'<rect x="105" y="344" width="70" height="14" fill="{PALE}" stroke="{RIGID}"/>')
    line([base, elbow, wrist, rigid_tip], RIGID, 3, "7 5")
    line([base, (323, 233), (562, 222), bent_tip], BENT, 4)
    frame(70, 94, 0, "W", -24, 20)
    frame(*base, 0, "B", -26, 18)
    frame(323, 233, -3, "L", -8, 26, BENT)
    frame(*rigid_tip, 0, "T", -22, -8, RIGID)
    frame(*bent_tip, -4, "D", -22, 16, BENT)
    line([rigid_tip, bent_tip], "#c0392b", 2)
    text(350, 336, "X_WB", 14)
    text(440, 336, "pose of the base in the world, from calibrate", 12)
    text(350, 356, "X_BL", 14)
    text(440, 356, "pose of row L of the arm in the base, deflected", 12)
    text(350, 376, "p_WT, p_WD", 14)
    text(440, 376, "tip of the rigid and of the deflected arm in the world", 12)
    text(350, 312, "rigid arm (dashed), deflected arm (solid), deflection (red)", 12, RIGID)
    with open(path, "w", encoding="utf-8") as file:
        file.write('<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 760 400" width="760" font-family="Helvetica, Arial, sans-serif">\n'
                   + "\n".join(parts) + "\n</svg>\n")


main(sys.argv[1])
