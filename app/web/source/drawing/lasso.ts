// Selection by a lasso: a loop drawn over a picture, and the points inside the loop. A click without a drag remains a
// click.

export type Loop = [number, number][];

/** Returns true if a point is inside the loop, whose last point is joined to the first. */
export function isInside(loop: readonly (readonly [number, number])[], x: number, y: number): boolean {
  let inside = false;
  for (let i = 0, j = loop.length - 1; i < loop.length; j = i++) {
    const [xi, yi] = loop[i],
      [xj, yj] = loop[j];
    if (yi > y !== yj > y && x < ((xj - xi) * (y - yi)) / (yj - yi) + xi) inside = !inside;
  }
  return inside;
}

/** Distance from its start at which a drag becomes a loop [pixels]. */
const LEAST = 6;
const SVG = "http://www.w3.org/2000/svg";

function makeOutline(): {picture: SVGSVGElement; line: SVGPolygonElement} {
  const picture = document.createElementNS(SVG, "svg"),
    line = document.createElementNS(SVG, "polygon");
  picture.setAttribute("class", "lasso");
  picture.append(line);
  return {picture, line};
}

/**
 * Follows a pointer that draws a loop over an element, and reports the loop in the element's pixels on release. With
 * Shift the loop adds to the selection. The outline is drawn in `stage`, which must cover the element.
 */
export function followLasso(
  element: HTMLElement,
  stage: HTMLElement,
  onLoop: (loop: Loop, isMore: boolean) => void,
): () => void {
  const {picture, line} = makeOutline();
  const listening = new AbortController();
  let loop: Loop | null = null,
    isDrawn = false;
  const end = () => {
    picture.remove();
    loop = null;
  };
  const on = <K extends keyof HTMLElementEventMap>(
    name: K,
    act: (event: HTMLElementEventMap[K]) => void,
    capture = false,
  ) => element.addEventListener(name, act, {signal: listening.signal, capture});
  const placeOf = (event: PointerEvent): [number, number] => {
    const box = element.getBoundingClientRect();
    return [event.clientX - box.left, event.clientY - box.top];
  };
  on("pointerdown", (event) => {
    if (event.button !== 0) return;
    loop = [placeOf(event)];
    isDrawn = false;
  });
  on("pointermove", (event) => {
    if (!loop || event.buttons === 0) return;
    const at = placeOf(event);
    loop.push(at);
    if (!isDrawn && Math.hypot(at[0] - loop[0][0], at[1] - loop[0][1]) >= LEAST) {
      isDrawn = true;
      element.setPointerCapture(event.pointerId);
      stage.append(picture);
    }
    if (isDrawn) line.setAttribute("points", loop.map(([x, y]) => `${x},${y}`).join(" "));
  });
  on("pointerup", (event) => {
    if (loop && isDrawn) onLoop(loop, event.shiftKey);
    end();
  });
  on("pointercancel", end);
  on("click", (event) => isDrawn && event.stopImmediatePropagation(), true);
  return () => {
    listening.abort();
    end();
  };
}
