// ---- tooltip.js: what is under the pointer, said beside it.

/// Shows lines of text (the first is the name) beside the pointer; nothing for null.
function showTooltip(event, lines) {
  const box = document.getElementById("tooltip");
  box.hidden = !lines;
  if (!lines) return;
  const [name, ...others] = lines;
  box.replaceChildren(
      el("strong", {}, name), ...others.filter((line) => line !== null).map((line) => el("div", {}, line)));
  placeBeside(box, event.clientX, event.clientY);
}

/// Shows `describe(px, py)`, lines or null, for the pixel under the pointer of a picture drawn `width` pixels wide.
function hoverPicture(picture, width, describe) {
  picture.addEventListener("pointermove", (event) => {
    const shown = picture.getBoundingClientRect();
    const zoom = width / shown.width;
    showTooltip(event, describe((event.clientX - shown.left) * zoom, (event.clientY - shown.top) * zoom));
  });
  picture.addEventListener("pointerleave", (event) => showTooltip(event, null));
}

/// Shows `describe(hole)` for the hole under the pointer of a sheet's canvas.
function hoverHoles(canvas, sheet, frame, describe) {
  hoverPicture(canvas, frame.width, (px, py) => {
    const hole = nearestHole(sheet, frame.point(px, py));
    return hole ? describe(hole) : null;
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
