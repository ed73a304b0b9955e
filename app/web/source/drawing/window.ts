// Long lists of which only the rows in sight are in the page, so that thousands cost nothing.
import {useSignal} from "@preact/signals";
import type {RefObject} from "preact";
import {useEffect} from "preact/hooks";

/** Rows above and below those in sight that are there too. */
const MORE = 8;

/** Of `count` rows, each so high in pixels, those that a box shows: from the first to before the last. */
export function useWindow(box: RefObject<HTMLElement>, count: number, high: number): {first: number; last: number} {
  const top = useSignal(0),
    height = useSignal(400);
  useEffect(() => {
    const element = box.current!;
    const look = () => {
      top.value = element.scrollTop;
      height.value = element.clientHeight;
    };
    const observer = new ResizeObserver(look);
    observer.observe(element);
    element.addEventListener("scroll", look);
    return () => observer.disconnect();
  }, []);
  const first = Math.max(0, Math.floor(top.value / high) - MORE);
  return {first, last: Math.min(count, first + Math.ceil(height.value / high) + 2 * MORE)};
}
