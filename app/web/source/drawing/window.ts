// Windowing of long lists: the page contains only the visible rows, so that thousands of rows do not slow it down.
import {useSignal} from "@preact/signals";
import type {RefObject} from "preact";
import {useEffect} from "preact/hooks";

/** Number of rows rendered above and below the visible rows. */
const MORE = 8;

/** Returns the range of visible rows, from `first` to before `last`, of `count` rows that are `high` pixels high. */
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
