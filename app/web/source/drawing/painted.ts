// A canvas that is painted at every change of its size and of its inputs.
import type {RefObject} from "preact";
import {useLayoutEffect} from "preact/hooks";

/** Paints at every change of `inputs`, including colours, at once, so that print has its own colours. */
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
