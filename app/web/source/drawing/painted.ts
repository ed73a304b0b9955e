// A canvas that is painted at every size of its place, and with every change of what it shows.
import type {RefObject} from "preact";
import {useLayoutEffect} from "preact/hooks";

/** Paints with every change of `inputs`, colours among them, at once, so that paper has its own. */
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
