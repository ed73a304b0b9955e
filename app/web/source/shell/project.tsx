// Saving of the work as a project in the opened folder. Unsaved work is never discarded without confirmation.
import {computed, signal, useSignal} from "@preact/signals";
import {submitting, TextInput} from "../drawing/fields";
import type {Problem, WorkbenchState} from "../server/documents";
import {pageWords} from "../server/page_words";
import {asProblem, post, ServerProblem} from "../server/requests";
import {cell, forget, report, reporting, state, takeState} from "../server/workbench";
import {Dialog} from "./dialog";
import {ExportMenu} from "./export_menu";
import {closeDialog, dialog} from "./page_state";
import {ProblemWords} from "./states";

const project = computed(() => state.value?.project ?? null);

/** Common label of notices about opened files: opening another file removes them. */
export const OPENING = "opening";

/** Action that waits until the work is saved or discarded; null if there is none. */
const opening = signal<{name: string; go: (discard: boolean) => Promise<void>} | null>(null);

// ---- saving

async function saveAs(file: string, overwrite: boolean): Promise<Problem | null> {
  try {
    takeState(await post<WorkbenchState>("/api/project/save", {file, overwrite}));
    return null;
  } catch (error) {
    return asProblem(error);
  }
}

/** Saves under the current name; asks for a name if there is none. */
export async function save(): Promise<void> {
  const file = project.value?.file;
  if (!file) {
    dialog.value = "save";
    return;
  }
  reporting("Not saved")(await saveAs(file, true));
}

export function SaveDialog() {
  return (
    <Dialog name="save" title="Save the project">
      <SaveForm />
    </Dialog>
  );
}

function SaveForm() {
  const name = useSignal(project.value?.file ?? `${cell.value?.name ?? "work"}.tubeplan`);
  const problem = useSignal<Problem | null>(null);
  const write = async (overwrite: boolean) => {
    problem.value = await saveAs(name.value.trim(), overwrite);
    if (problem.value === null) closeDialog("save");
  };
  return (
    <form class="save-form" onSubmit={submitting(() => write(false))}>
      <label class="field">
        name, in {state.value?.folder}
        <TextInput of={name} autofocus onEdit={() => (problem.value = null)} />
      </label>
      <p class="muted">
        One file with the cell, the readings, every model with its figures and what is set aside. Open brings it back,
        here or elsewhere.
      </p>
      {problem.value ? <ProblemWords problem={problem.value} /> : null}
      <div class="row">
        <button class="button first" type="submit" disabled={name.value.trim() === ""}>
          Save
        </button>
        {problem.value ? (
          <button class="button" type="button" onClick={() => void write(true)}>
            Replace what is there
          </button>
        ) : null}
      </div>
    </form>
  );
}

// ---- opening something else

/** Opens a cell, project or session; asks first if unsaved work would be discarded. */
export async function openInstead(path: string, body: Record<string, unknown>, name: string): Promise<void> {
  const go = async (discard: boolean) => {
    forget(OPENING);
    try {
      takeState(await post<WorkbenchState>(path, {...body, discard}));
      dialog.value = "";
      opening.value = null;
    } catch (error) {
      if (error instanceof ServerProblem && error.status === 409 && project.value?.unsaved && !discard) {
        opening.value = {name, go};
        dialog.value = "unsaved";
      } else report(`${name} cannot be opened`, error, OPENING);
    }
  };
  await go(false);
}

export function UnsavedDialog() {
  return (
    <Dialog name="unsaved" title="Keep the work?">
      <p class="lead">
        The work on <b>{cell.value?.name}</b> is not saved in a project. Opening {opening.value?.name} closes it
        {project.value?.kept ? "; it remains under Open, Recent" : ""}.
      </p>
      <div class="row">
        <button class="button first" onClick={() => void save()}>
          Save it first …
        </button>
        <button class="button" onClick={() => void opening.value?.go(true)}>
          Open {opening.value?.name}
        </button>
        <button class="button" onClick={() => closeDialog("unsaved")}>
          Cancel
        </button>
      </div>
    </Dialog>
  );
}

// ---- part of the header

/** Exports: file name, label, and whether the export is available in a state. */
const EXPORTS: [string, string, (now: WorkbenchState) => unknown][] = [
  ["cell.yaml", "Model", () => true],
  ["project.tubeplan", "Project", () => true],
  ["cell-arm.yaml", "Its arm", ({cell}) => cell.has_arm_file],
  ["arm.urdf", "The arm, rigid, for ROS", () => true],
  ["measurements.csv", "Readings", ({measurements}) => measurements],
  ["compare.html", "Comparison, report", ({results}) => results.compare],
  ["diagnose.html", "Diagnosis, report", ({results}) => results.diagnose],
  ["ladder.html", "Ladder, report", ({results}) => results.ladder],
];

export function ProjectTools() {
  const now = state.value;
  if (!now) return null;
  const isUnsaved = project.value?.unsaved ?? false;
  const words = isUnsaved ? "not saved as a project" : project.value?.file ? `saved as ${project.value.file}` : "";
  const kept = project.value?.problem
    ? `, not autosaved: ${pageWords(project.value.problem)}`
    : project.value?.kept
      ? "; autosaved"
      : "";
  const exports = EXPORTS.filter(([, , isThere]) => isThere(now)).map(([name, title]) => [name, title] as const);
  return (
    <div class="project-tools">
      <button
        class="button"
        title={`Save as a project (Ctrl+S)${words ? `: ${words}` : ""}${kept}`}
        onClick={() => void save()}
      >
        {isUnsaved ? <i class="unsaved" aria-hidden="true" /> : null}
        Save<span class="hidden">{words}</span>
      </button>
      <ExportMenu exports={exports} />
    </div>
  );
}
