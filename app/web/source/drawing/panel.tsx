// A panel of a view, with a head and a body; and lists of names with values.
import type {ComponentChildren} from "preact";

interface PanelProps {
  title?: ComponentChildren;
  /** Further content of the head, between the title and the end. Without title, head and end, the panel has no head. */
  head?: ComponentChildren;
  end?: ComponentChildren;
  /** Further CSS classes of the panel and of its body. */
  kind?: string;
  body?: string;
  /** ARIA role of the body. */
  role?: "tabpanel";
  children?: ComponentChildren;
}

export function Panel({title, head, end, kind = "", body = "", role, children}: PanelProps) {
  return (
    <section class={`panel ${kind}`}>
      {title || head || end ? (
        <header>
          {title ? <h2>{title}</h2> : null}
          {head}
          {end ? <div class="end">{end}</div> : null}
        </header>
      ) : null}
      <div class={`panel-body ${body}`} role={role}>
        {children}
      </div>
    </section>
  );
}

/** Names with their values, as a description list. */
export function Terms({rows}: {rows: readonly (readonly [ComponentChildren, ComponentChildren])[]}) {
  return (
    <>
      {rows.map(([name, value]) => (
        <>
          <dt>{name}</dt>
          <dd>{value}</dd>
        </>
      ))}
    </>
  );
}

export function Figures({rows}: Parameters<typeof Terms>[0]) {
  return (
    <dl class="figures">
      <Terms rows={rows} />
    </dl>
  );
}
