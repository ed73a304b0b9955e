// The header: cell and readings, the stack of models with undo and redo, running jobs, dark or light colours. A narrow
// window has it in two rows.
import {Icon} from "../drawing/icons";
import {chooseScheme, isDark, scheme} from "../drawing/colours";
import {duration, plural, whole} from "../../../drawing/numbers.js";
import type {Job} from "../server/documents";
import type {ReadingsInfo} from "../server/state_documents";
import {cell, connection, order, runningJobs, state} from "../server/workbench";
import {ModelSteps} from "./model_steps";
import {dialog} from "./page_state";
import {ProjectTools} from "./project";
import {canRedo, canUndo, redo, undo} from "./undo";
import {UnitMenu} from "./unit_menu";

function ModelStack() {
  const now = state.value;
  if (!now) return <div class="models" />;
  return (
    <div class="models">
      <button
        class="tool"
        title={stepTitle("Undo", now.undo_words, "Ctrl+Z")}
        disabled={!canUndo.value}
        onClick={() => void undo()}
      >
        <Icon name="undo" />
      </button>
      <button
        class="tool"
        title={stepTitle("Redo", now.redo_words, "Ctrl+Shift+Z")}
        disabled={!canRedo.value}
        onClick={() => void redo()}
      >
        <Icon name="redo" />
      </button>
      <ModelSteps />
    </div>
  );
}

/** Returns, for example, "Undo: marks of readings (Ctrl+Z)". */
function stepTitle(word: string, what: string, key: string): string {
  return `${word}${what ? `: ${what}` : ""} (${key})`;
}

function JobProgress({job}: {job: Job}) {
  const share = job.total > 0 ? Math.min(1, job.done / job.total) : null;
  return (
    <div class="job" role="status">
      <div class="job-words">
        <b>{job.label || job.kind}</b>
        <span>{job.stage}</span>
        <span class="job-figures">
          {job.total > 0 ? `${job.done.toLocaleString("en")} / ${job.total.toLocaleString("en")}` : ""}
          {job.left_s !== null && job.left_s > 1 ? ` · ${duration(job.left_s)} left` : ""}
        </span>
      </div>
      <progress max={1} value={share ?? undefined} aria-label={job.label || job.kind} />
      <button class="tool" title="Stop" onClick={() => order("Stop", `/api/jobs/${job.id}/cancel`)}>
        <Icon name="close" size={16} />
        <span class="hidden">Stop {job.label || job.kind}</span>
      </button>
    </div>
  );
}

function Connection() {
  const words = {live: "connected", connecting: "connecting", lost: "the program does not respond"}[connection.value];
  return (
    <span class={`connection ${connection.value}`} role="status" title={words}>
      <span class="hidden">{words}</span>
    </span>
  );
}

function SchemeSwitch() {
  const next = isDark() ? "light" : "dark";
  void scheme.value;
  return (
    <button class="tool" title={`${next === "dark" ? "Dark" : "Light"} colours (D)`} onClick={() => chooseScheme(next)}>
      <Icon name={next === "dark" ? "moon" : "sun"} />
    </button>
  );
}

/** Returns a phrase such as ", 68 set aside, 4 held out". */
function asideText({set_aside, held_out}: ReadingsInfo): string {
  return `${set_aside > 0 ? `, ${whole(set_aside)} set aside` : ""}${held_out > 0 ? `, ${whole(held_out)} held out` : ""}`;
}

export function Header() {
  const readings = state.value?.measurements ?? null;
  const job = runningJobs.value[0];
  return (
    <header class="header">
      <span class="wordmark">Tubeplan</span>
      <button class="chip" title="Open a cell or readings (O)" onClick={() => (dialog.value = "open")}>
        <Icon name="open" size={16} />
        <b>{cell.value?.name ?? "–"}</b>
        <span class="chip-more">
          {readings
            ? `${readings.name} · ${plural(readings.readings, "reading")}${asideText(readings)}`
            : "no readings"}
        </span>
      </button>
      <ModelStack />
      {job ? <JobProgress key={job.id} job={job} /> : null}
      <div class="header-space" />
      <ProjectTools />
      <Connection />
      <UnitMenu />
      <SchemeSwitch />
      <button class="tool" title="Keys (?)" onClick={() => (dialog.value = "keys")}>
        <Icon name="help" />
      </button>
    </header>
  );
}
