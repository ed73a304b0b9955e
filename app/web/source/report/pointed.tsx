// Text about the element under the pointer; omitted on paper.
import type {ComponentChildren} from "preact";
import {useSignal} from "@preact/signals";

/** Lines of text about the pointed element, its name first; null if nothing is pointed at. */
export type Lines = (string | null | false)[] | null;

interface PointedProps {
  find: (event: PointerEvent) => Lines;
  class: string;
  style?: Record<string, string>;
  children: ComponentChildren;
}

export function Pointed({find, class: name, style, children}: PointedProps) {
  const tip = useSignal<{x: number; y: number; width: number; lines: string[]} | null>(null);
  const point = (event: PointerEvent) => {
    const box = (event.currentTarget as HTMLElement).getBoundingClientRect(),
      lines = find(event)?.filter((line): line is string => !!line);
    tip.value = lines ? {x: event.clientX - box.left, y: event.clientY - box.top, width: box.width, lines} : null;
  };
  return (
    <div class={`pointed ${name}`} style={style} onPointerMove={point} onPointerLeave={() => (tip.value = null)}>
      {children}
      {tip.value ? <Tip {...tip.value} /> : null}
    </div>
  );
}

function Tip({x, y, width, lines: [first, ...others]}: {x: number; y: number; width: number; lines: string[]}) {
  const side = x > width / 2 ? {right: `${width - x + 14}px`} : {left: `${x + 14}px`};
  return (
    <div class="tip" role="status" style={{top: `${y + 12}px`, ...side}}>
      <b>{first}</b>
      {others.map((line) => (
        <span>{line}</span>
      ))}
    </div>
  );
}
