// What is under the pointer, said beside it.
import {el} from "./elements.js";

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
export function hoverPicture(picture, width, describe) {
  picture.addEventListener("pointermove", (event) => {
    const shown = picture.getBoundingClientRect();
    const zoom = width / shown.width;
    showTooltip(event, describe((event.clientX - shown.left) * zoom, (event.clientY - shown.top) * zoom));
  });
  picture.addEventListener("pointerleave", (event) => showTooltip(event, null));
}

/// Shows `describe(hole)` for the hole under the pointer of a sheet's canvas.
export function hoverHoles(canvas, frame, describe) {
  hoverPicture(canvas, frame.width, (px, py) => {
    const hole = frame.holeAt(px, py);
    return hole ? describe(hole) : null;
  });
}

function placeBeside(box, x, y) {
  const {width, height} = box.getBoundingClientRect();
  box.style.left = `${Math.max(4, x + 16 + width > innerWidth ? x - 16 - width : x + 16)}px`;
  box.style.top = `${Math.max(4, Math.min(y + 16, innerHeight - height - 4))}px`;
}
