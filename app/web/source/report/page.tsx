// A report as a page: head, list of sections, sections, and facts.
import type {ComponentType} from "preact";
import {useErrorBoundary} from "preact/hooks";
import type {OfReport} from "./parts";
import {textOf, type Report} from "./values";

export interface SectionKind {
  id: string;
  title: string;
  Content: ComponentType<OfReport>;
  /** Returns true if a document has this section; if missing, every document has it. */
  of?: (report: Report) => boolean;
}

export interface PageKind {
  title: string;
  Head: ComponentType<OfReport>;
  sections: readonly SectionKind[];
  /** Facts of the report, as pairs of name and value. */
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

/** Section that shows a note if rendering it fails, so that the other sections are not affected. */
function Guarded({section: {Content}, report}: {section: SectionKind} & OfReport) {
  const [error] = useErrorBoundary();
  if (error) return <p class="missing">This part could not be drawn: {error.message}</p>;
  return <Content report={report} />;
}

/** Facts at the head of the report. */
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
