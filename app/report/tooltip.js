// ---- tooltip.js: what is under the pointer, said beside it.

/// Shows `describe(hole)` (lines of text; the first is the name) for the hole under the pointer of a sheet's canvas.
function hoverHoles(canvas, sheet, frame, describe) {
  const box = document.getElementById("tooltip");
  canvas.addEventListener("pointermove", (event) => {
    const shown = canvas.getBoundingClientRect();
    const zoom = frame.width / shown.width;
    const place = frame.point((event.clientX - shown.left) * zoom, (event.clientY - shown.top) * zoom);
    const hole = nearestHole(sheet, place);
    if (!hole) {
      box.hidden = true;
      return;
    }
    const [name, ...lines] = describe(hole);
    box.replaceChildren(
        el("strong", {}, name), ...lines.filter((line) => line !== null).map((line) => el("div", {}, line)));
    box.hidden = false;
    placeBeside(box, event.clientX, event.clientY);
  });
  canvas.addEventListener("pointerleave", () => {
    box.hidden = true;
  });
}

function nearestHole(sheet, place) {
  let best = null, least = 0.75 * sheet.pitch;
  for (const hole of sheet.holes) {
    const away = Math.hypot(hole.x - place[0], hole.y - place[1]);
    if (away < least) [best, least] = [hole, away];
  }
  return best;
}

function placeBeside(box, x, y) {
  const {width, height} = box.getBoundingClientRect();
  box.style.left = `${Math.max(4, x + 16 + width > innerWidth ? x - 16 - width : x + 16)}px`;
  box.style.top = `${Math.max(4, Math.min(y + 16, innerHeight - height - 4))}px`;
}
