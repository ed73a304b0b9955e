// The next tube in large letters, the confirmation of its identity, and the outcome of the visit.
import {useSignal} from "@preact/signals";
import {useEffect} from "preact/hooks";
import {isTyping, submitting, withPoint} from "../drawing/fields";
import {fixed} from "../../../drawing/numbers.js";
import {confirm, finding, mark, person, records, type MarkKind, type NextTube} from "./desk";

export function NextPanel({tube}: {tube: NextTube}) {
  if (tube.tube === null)
    return (
      <section class="panel desk-next">
        <p class="desk-tube">Nothing is left</p>
        <p class="muted">Every tube of this part is done, excluded or held.</p>
      </section>
    );
  return (
    <section class="panel desk-next">
      <p class="desk-leg">
        Steam generator {tube.steam_generator}, {tube.leg} leg
      </p>
      <p class="desk-tube" data-tube={tube.tube}>
        Row {tube.row} <span>Column {tube.column}</span>
      </p>
      <p>
        {tube.package}: tool {tube.tool}
        {tube.extent ? `, extent ${tube.extent}` : ""}; x {fixed(tube.x, 3)}, y {fixed(tube.y, 3)} {tube.units.length}
        {tube.standing === "queued" ? "; visited before" : ""}
      </p>
      <Confirmation tube={tube} />
      <Marks tube={tube} />
      <p class="muted">{tube.left} left in this part</p>
    </section>
  );
}

/** Form for the confirmation that the package requires, with the result of the latest one. */
function Confirmation({tube}: {tube: NextTube}) {
  if (tube.confirm === "none") return null;
  const isRead = tube.confirm === "read-back";
  return (
    <form
      key={tube.tube}
      class="desk-confirm"
      onSubmit={submitting((form) => {
        const typed = (name: string) => String(new FormData(form).get(name) ?? "").trim();
        const number = (name: string) => Number(withPoint(typed(name)));
        return confirm(typed("by"), isRead ? {read_back: typed("read")} : {position: [number("x"), number("y")]});
      })}
    >
      <input name="by" required placeholder={isRead ? "who reads" : "who measures"} aria-label="Who confirms" />
      {isRead ? (
        <input name="read" required placeholder="A/hot/R12C40, as read at the tool" aria-label="Tube as read" />
      ) : (
        <>
          <input
            name="x"
            required
            inputMode="decimal"
            placeholder={`x, ${tube.units.length}`}
            aria-label="Measured x"
          />
          <input
            name="y"
            required
            inputMode="decimal"
            placeholder={`y, ${tube.units.length}`}
            aria-label="Measured y"
          />
        </>
      )}
      <button class="button" type="submit">
        Confirm
      </button>
      <Found />
    </form>
  );
}

function Found() {
  const found = finding.value;
  if (!found) return <p class="muted">The tool may not enter before the tube is confirmed.</p>;
  if (found.same)
    return (
      <p class="desk-found good" role="status">
        ✓ {found.tube} is confirmed
      </p>
    );
  return (
    <p class="desk-found bad" role="alert">
      ✕ {found.found || "No hole"} was found, not {found.tube}: {found.reason}. No tool may enter.
    </p>
  );
}

/** One button for each mark, with its key; a reason for the marks that need one. */
function Marks({tube}: {tube: NextTube}) {
  const reason = useSignal("");
  const kinds = records.value.document?.marks ?? [];
  const isReady = (kind: MarkKind) =>
    person.value.trim() !== "" &&
    (!kind.needs_reason || reason.value.trim() !== "") &&
    (!kind.needs_tool || tube.confirm === "none" || finding.value?.same === true);
  const choose = async (kind: MarkKind) => {
    if (isReady(kind) && (await mark(kind, reason.value.trim()))) reason.value = "";
  };
  useEffect(() => {
    const follow = (event: KeyboardEvent) => {
      if (isTyping(event) || event.ctrlKey || event.metaKey || event.altKey) return;
      const kind = kinds.find(({key}) => key === event.key);
      if (!kind) return;
      event.preventDefault();
      event.stopPropagation();
      void choose(kind);
    };
    document.addEventListener("keydown", follow, true);
    return () => document.removeEventListener("keydown", follow, true);
  });
  return (
    <div class="desk-marks" role="group" aria-label="Result of the visit">
      {kinds.map((kind) => (
        <button
          key={kind.name}
          class={`button mark-${kind.standing}`}
          disabled={!isReady(kind)}
          title={`${kind.words} (${kind.key})`}
          onClick={() => void choose(kind)}
        >
          <kbd>{kind.key}</kbd> {kind.name}
        </button>
      ))}
      <input
        value={reason.value}
        placeholder="reason, where one is needed"
        aria-label="Reason"
        onInput={(event) => (reason.value = event.currentTarget.value)}
      />
      {person.value.trim() === "" ? <p class="muted">Enter your name above.</p> : null}
    </div>
  );
}
