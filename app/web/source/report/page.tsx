// A report as a page: its head, its sections with a list of them, what it is of.
import type {ComponentType} from "preact";
import {useErrorBoundary} from "preact/hooks";
import type {OfReport} from "./parts";
import {textOf, type Report} from "./values";

export interface SectionKind {
  id: string;
  title: string;
  Content: ComponentType<OfReport>;
  /** Whether a document has such a section; all have without it. */
  of?: (report: Report) => boolean;
}

export interface PageKind {
  title: string;
  Head: ComponentType<OfReport>;
  sections: readonly SectionKind[];
  /** What the report is of, name by name. */
  facts: (report: Report) => readonly (readonly [string, unknown])[];
}

export function ReportPage({kind, report}: {kind: PageKind} & OfReport) {
  const sections = kind.sections.filter(({of}) => !of || of(report));
  const facts = kind.facts(report).filter(([, value]) => textOf(value, "") !== "");
  return (
    <>
      <header>
        <h1>{textOf(report.title, kind.title)}</h1>
        <kind.Head report={report} />
      </header>
      <nav aria-label="Contents">
        {sections.map(({id, title}) => (
          <a href={`#${id}`}>{title}</a>
        ))}
      </nav>
      <main>
        {sections.map((section, k) => (
          <section id={section.id}>
            <h2>
              <span class="count">{k + 1}</span> {section.title}
            </h2>
            <Guarded section={section} report={report} />
          </section>
        ))}
      </main>
      <footer id="foot">{facts.map(([name, value]) => `${name} ${textOf(value)}`).join(" \u00b7 ") || "\u00a0"}</footer>
    </>
  );
}

/** A section that cannot be drawn says so and leaves the others alone. */
function Guarded({section: {Content}, report}: {section: SectionKind} & OfReport) {
  const [error] = useErrorBoundary();
  if (error) return <p class="missing">This part could not be drawn: {error.message}</p>;
  return <Content report={report} />;
}

/** The figures at its head. */
export function Summary({facts}: {facts: readonly (readonly [string, unknown])[]}) {
  if (facts.length === 0) return null;
  return (
    <dl class="summary">
      {facts.map(([name, value]) => (
        <div>
          <dt>{name}</dt>
          <dd>{textOf(value)}</dd>
        </div>
      ))}
    </dl>
  );
}
