// A canvas that is painted whenever its size or its inputs change.
import type {RefObject} from "preact";
import {useLayoutEffect} from "preact/hooks";

/**
 * Calls `paint` whenever the size of the canvas or `inputs`, such as the colours, change. Painting is synchronous, so
 * that a print has the print colours.
 */
export function usePainted(
  canvas: RefObject<HTMLCanvasElement>,
  paint: (canvas: HTMLCanvasElement) => void,
  inputs: readonly unknown[],
): void {
  useLayoutEffect(() => {
    const element = canvas.current!;
    let painted = "";
    const draw = () => {
      const size = `${element.clientWidth} ${element.clientHeight}`;
      if (size !== painted) paint(element);
      painted = size;
    };
    const observer = new ResizeObserver(draw);
    observer.observe(element.parentElement!);
    draw();
    return () => observer.disconnect();
  }, inputs);
}
