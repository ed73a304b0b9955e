// The figures at the head of a report.
import {textOf} from "./values";

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
