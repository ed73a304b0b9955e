// Parts of reports: leads, cards, tables, legends, and notes on missing values.
import type {ComponentChildren} from "preact";
import {Icon} from "../drawing/icons";
import {MarkIcon, type Mark} from "../drawing/marks";
import {Table, type TableProps} from "../drawing/table";
import type {Report} from "./values";

export {Table};

export interface OfReport {
  report: Report;
}

interface WithChildren {
  children?: ComponentChildren;
}

export function Missing({what}: {what: string}) {
  return <p class="missing">{what}: not recorded.</p>;
}

export function Lead({children}: WithChildren) {
  return <p class="lead">{children}</p>;
}

export function Card({title, class: name = "", children}: {title?: ComponentChildren; class?: string} & WithChildren) {
  return (
    <div class={`card ${name}`}>
      {title ? <h3>{title}</h3> : null}
      {children}
    </div>
  );
}

/** Table on a card; without rows, a note says that `what` is missing. */
export function TableCard({what, title, ...table}: {what: string; title?: ComponentChildren} & TableProps) {
  if (table.rows.length === 0 && !title) return <Missing what={what} />;
  return <Card title={title}>{table.rows.length === 0 ? <Missing what={what} /> : <Table {...table} />}</Card>;
}

export function Reasons({children}: {children: readonly ComponentChildren[]}) {
  return (
    <ul class="reasons">
      {children.map((reason) => (
        <li>{reason}</li>
      ))}
    </ul>
  );
}

/** Legend of marks, or of other signs given by their CSS class, each followed by its text. */
export function Legend({children}: {children: readonly (readonly [Mark | string, ComponentChildren])[]}) {
  return (
    <ul class="legend">
      {children.map(([mark, words]) => (
        <li>
          {typeof mark === "string" ? <i class={mark} aria-hidden="true" /> : <MarkIcon mark={mark} />} {words}
        </li>
      ))}
    </ul>
  );
}

/** Name of an effect or a parameter above its description. */
export function Named({name, words}: {name: ComponentChildren; words?: string}) {
  return (
    <span class="effect-name">
      {name}
      {words ? <small>{words}</small> : null}
    </span>
  );
}

/** Button that prints only its section of the page. */
export function PrintButton({children, prepare}: {prepare?: () => void} & WithChildren) {
  const print = (event: MouseEvent) => {
    prepare?.();
    const section = (event.currentTarget as HTMLElement).closest("section")!;
    section.classList.add("printed");
    document.body.classList.add("section-only");
    window.print();
    document.body.classList.remove("section-only");
    section.classList.remove("printed");
  };
  return (
    <button type="button" class="button small print" onClick={print}>
      <Icon name="print" size={14} /> {children}
    </button>
  );
}
