// The sheet view: every hole by state, reach, steps, predicted error or residual; selecting; what a hole is.
import {choicesOf, Segments} from "../drawing/segments";
import {computed, effect, signal} from "@preact/signals";
import {useSignal} from "@preact/signals";
import {MarkIcon} from "../drawing/marks";
import {Icon} from "../drawing/icons";
import {fixed, plural, whole} from "../drawing/numbers";
import type {FieldDocument, InverseDocument, PlanDocument, ReachDocument} from "../server/documents";
import {post} from "../server/requests";
import {cell, report, result, runJob, runningJob, sheetDocument, units} from "../server/workbench";
import {picked, select, selection, sheet, toggleSelected, view} from "../shell/page_state";
import {Nothing, ProblemWords, Waiting} from "../shell/states";
import {poseRequest, showHole, whyNot} from "../arm/pose_link";
import {byField, byReach, byState, bySteps, type Colouring} from "./colourings";
import {holeName, legWords, type SheetModel} from "./sheet_model";
import {SheetPicture} from "./sheet_picture";

type Choice = "state" | "reach" | "steps" | "centring" | "residual" | "sag";

const CHOICES: [Choice, string][] = [
  ["state", "State"],
  ["reach", "Reach"],
  ["steps", "Steps"],
  ["centring", "Predicted error"],
  ["residual", "Residual"],
  ["sag", "Sag"],
];
const TITLES: Record<string, string> = {centring: "Predicted error", residual: "Residual", sag: "Sag"};

export const chosen = signal<Choice>("state");
const hiddenKinds = signal<ReadonlySet<number>>(new Set());
effect(() => {
  void chosen.value;
  hiddenKinds.value = new Set();
});

const reach = result<ReachDocument>("reach"),
  field = result<FieldDocument>("field"),
  plan = result<PlanDocument>("plan");

const colouring = computed<Colouring | null>(() => {
  const model = sheet.value;
  if (!model) return null;
  return madeColouring(model, chosen.value) ?? null;
});

function madeColouring(model: SheetModel, choice: Choice): Colouring | null {
  if (choice === "state") return byState(model);
  if (choice === "reach")
    return fits(reach.value.document?.reachable, model) ? byReach(model, reach.value.document!) : null;
  if (choice === "steps") return plan.value.document ? bySteps(model, plan.value.document, "predicted") : null;
  const found = field.value.document;
  return found && found.of === choice && fits(found.values, model) ? byField(model, found, TITLES[choice]) : null;
}

function fits(values: unknown[] | undefined, model: SheetModel): boolean {
  return values !== undefined && values.length === model.count;
}

const HOW: Record<string, {words: string; action: string}> = {
  reach: {words: "Which holes the arm can bring its tool under, and why not the others.", action: "Find the reach"},
  centring: {words: "How far from each hole's centre the tool comes.", action: "Predict the error"},
  residual: {words: "How far the model is from each hole that was touched.", action: "Work out the residual"},
  sag: {words: "How far the tool sags under each hole.", action: "Work out the sag"},
  steps: {words: "How far the stepped tool goes in, once a plan is made.", action: "Make a plan"},
};

function compute(choice: Choice): void {
  if (choice === "steps") view.value = "plan";
  else if (choice === "reach") void runJob("Reach", "/api/reach");
  else void runJob(TITLES[choice], "/api/field", {of: choice});
}

export function SheetView() {
  const loaded = sheetDocument.value;
  if (cell.value && !cell.value.has_sheet) {
    return (
      <Nothing title={`${cell.value.name} has no tube sheet`}>
        <p>
          Its arm stands on a bench. Open a cell with a sheet to see holes; the arm and the error are there all the
          same.
        </p>
        <button class="button" onClick={() => (view.value = "error")}>
          To the error
        </button>
      </Nothing>
    );
  }
  if (loaded.problem)
    return (
      <Nothing title="The sheet cannot be shown">
        <ProblemWords problem={loaded.problem} />
      </Nothing>
    );
  if (!sheet.value) return <Waiting words="Reading the sheet" isBusy />;
  const model = sheet.value,
    shown = colouring.value ?? byState(model);
  return (
    <div class="sheet-view">
      <section class="panel">
        <header>
          <h2>Colour by</h2>
          <Segments
            label="Colour by"
            choices={choicesOf(CHOICES)}
            value={chosen.value}
            onChoose={(next) => (chosen.value = next)}
          />
          <div class="end no-print">
            <button class="tool" title="Print the map in black and white" onClick={() => window.print()}>
              <Icon name="print" />
            </button>
          </div>
        </header>
        <div class="panel-body flush">
          <SheetPicture
            sheet={model}
            colouring={shown}
            hidden={colouring.value ? hiddenKinds.value : undefined}
            selection={selection.value}
            picked={picked}
            onPick={(hole, event) => pick(hole, event.shiftKey || event.ctrlKey || event.metaKey)}
            onLasso={(holes, isMore) => select(holes, isMore)}
          />
          {colouring.value ? null : <ToCompute choice={chosen.value} />}
        </div>
      </section>
      <aside class="side">
        <LegendPanel colouring={colouring.value ?? shown} isReady={colouring.value !== null} />
        <SelectionPanel model={model} />
        <HolePanel model={model} colouring={shown} />
      </aside>
    </div>
  );
}

function pick(hole: number, isMore: boolean): void {
  if (isMore) toggleSelected(hole);
  picked.value = hole;
  void showHole(hole);
}

function ToCompute({choice}: {choice: Choice}) {
  const how = HOW[choice];
  const job = runningJob("reach", "field");
  return (
    <div class="to-compute">
      <p>{how.words}</p>
      <button class="button first" disabled={job !== null} onClick={() => compute(choice)}>
        {job ? "Working …" : how.action}
      </button>
    </div>
  );
}

function toggleKind(kind: number): void {
  const next = new Set(hiddenKinds.value);
  if (!next.delete(kind)) next.add(kind);
  hiddenKinds.value = next;
}

function LegendPanel({colouring: shown, isReady}: {colouring: Colouring; isReady: boolean}) {
  return (
    <section class="panel">
      <header>
        <h2>{isReady ? shown.title : "State"}</h2>
        <div class="end">
          <span class="muted">{whole(shown.of.length)} holes</span>
        </div>
      </header>
      <ul class="legend">
        {shown.kinds.map((kind, index) =>
          shown.counts[index] === 0 && shown.kinds.length > 6 ? null : (
            <li key={kind.name}>
              <label>
                <input type="checkbox" checked={!hiddenKinds.value.has(index)} onChange={() => toggleKind(index)} />
                <MarkIcon mark={kind.mark} />
                <span>{kind.name}</span>
                <b>{whole(shown.counts[index])}</b>
              </label>
              <button
                class="link"
                title={`Select these ${whole(shown.counts[index])} holes`}
                disabled={shown.counts[index] === 0}
                onClick={() => select(holesOf(shown, index))}
              >
                select
              </button>
            </li>
          ),
        )}
      </ul>
      {shown.meaning ? <p class="meaning muted">{shown.meaning}</p> : null}
    </section>
  );
}

function* holesOf(shown: Colouring, kind: number): Generator<number> {
  for (let i = 0; i < shown.of.length; ++i) if (shown.of[i] === kind) yield i;
}

const EXAMPLES = ["outer:2", "spread:60", "R1-10C5-9"];

export async function selectByText(text: string): Promise<void> {
  if (text.trim() === "") return select([]);
  try {
    select((await post<{holes: number[]}>("/api/select", {text})).holes);
  } catch (error) {
    report(`“${text}” selects nothing`, error);
  }
}

export function SelectionBox() {
  const text = useSignal("");
  return (
    <form
      class="select-box"
      onSubmit={(event) => {
        event.preventDefault();
        void selectByText(text.value);
      }}
    >
      <input
        aria-label="Select holes by ranges"
        placeholder="R1-10C5-9  outer:2  -plugged"
        value={text.value}
        spellcheck={false}
        onInput={(event) => (text.value = event.currentTarget.value)}
      />
      <button class="button" type="submit">
        Select
      </button>
      <div class="examples">
        {EXAMPLES.map((example) => (
          <button
            key={example}
            type="button"
            class="link"
            onClick={() => {
              text.value = example;
              void selectByText(example);
            }}
          >
            {example}
          </button>
        ))}
        {selection.value.size > 0 ? (
          <button type="button" class="link" onClick={() => select([])}>
            none
          </button>
        ) : null}
      </div>
    </form>
  );
}

function SelectionPanel({model}: {model: SheetModel}) {
  const count = selection.value.size;
  return (
    <section class="panel no-print">
      <header>
        <h2>Selection</h2>
        <div class="end">
          <b>{plural(count, "hole")}</b>
        </div>
      </header>
      <div class="panel-body">
        <SelectionBox />
        <div class="row">
          <button class="button" disabled={count === 0} onClick={() => (view.value = "plan")}>
            Plan these
          </button>
          <button class="button" disabled={count === model.count} onClick={() => select(invert(model))}>
            Invert
          </button>
        </div>
      </div>
    </section>
  );
}

function* invert(model: SheetModel): Generator<number> {
  for (let i = 0; i < model.count; ++i) if (!selection.value.has(i)) yield i;
}

function HolePanel({model, colouring: shown}: {model: SheetModel; colouring: Colouring}) {
  const hole = picked.value;
  if (hole < 0 || hole >= model.count) {
    return (
      <section class="panel grow no-print">
        <header>
          <h2>Hole</h2>
        </header>
        <div class="panel-body">
          <p class="muted">Pick a hole: the arm goes under it. Shift adds it to the selection.</p>
        </div>
      </section>
    );
  }
  return (
    <section class="panel grow">
      <header>
        <h2>{holeName(model, hole)}</h2>
        <span class="muted">{legWords(model.legs[hole])}</span>
        <div class="end no-print">
          <button class="button" aria-pressed={selection.value.has(hole)} onClick={() => toggleSelected(hole)}>
            {selection.value.has(hole) ? "Drop" : "Select"}
          </button>
        </div>
      </header>
      <div class="panel-body">
        <dl class="figures">
          <dt>x, y, z</dt>
          <dd>
            {[0, 1, 2].map((k) => fixed(model.world[3 * hole + k], 3)).join("  ")} {units.value.length}
          </dd>
          <dt>state</dt>
          <dd>{model.states[model.state[hole]] ?? "open"}</dd>
          {shown.words(hole).map((line) => (
            <>
              <dt></dt>
              <dd>{line}</dd>
            </>
          ))}
        </dl>
        <Posture inverse={poseRequest.inverse.value} />
      </div>
    </section>
  );
}

/** The joints that bring the tool under the hole, or why none do. */
function Posture({inverse}: {inverse: InverseDocument | null}) {
  if (!inverse) return <p class="muted reserve">Finding a posture …</p>;
  if (inverse.status !== "found" || !inverse.joints) return <p class="reserve bad">Out of reach: {whyNot(inverse)}</p>;
  const joints = cell.value?.joints ?? [];
  return (
    <>
      <dl class="figures">
        {inverse.joints.map((value, i) => (
          <>
            <dt>{joints[i]?.name}</dt>
            <dd>
              {fixed(value, 3)} {joints[i]?.unit}
            </dd>
          </>
        ))}
      </dl>
      <button class="button no-print" onClick={() => (view.value = "arm")}>
        See the arm
      </button>
    </>
  );
}
