// Opening: readings and cells of the folder, a file of one's own, or readings made for practice.
import {useEffect} from "preact/hooks";
import {useSignal} from "@preact/signals";
import type {Problem} from "../server/documents";
import {plural} from "../../../drawing/numbers.js";
import {asProblem, get} from "../server/requests";
import {cell, state} from "../server/workbench";
import {Dialog} from "./dialog";
import {loadFiles, openCell, openProject, openReadings, openRecent} from "./load";
import {closeDialog, dialog} from "./page_state";
import {PracticeForm} from "./practice_form";
import {ProblemWords, Waiting} from "./states";

interface Files {
  folder: string;
  cells: string[];
  measurements: string[];
  projects: string[];
  recent: RecentSession[];
}

/** A session that was kept, or put aside. */
interface RecentSession {
  file: string;
  cell: string;
  readings: string;
  models: string;
  saved: string;
}

export function OpenDialog() {
  return (
    <Dialog isOpen={dialog.value === "open"} title="Open" onClose={() => closeDialog("open")}>
      <OpenBody />
    </Dialog>
  );
}

function OpenBody() {
  const files = useSignal<Files | null>(null);
  const problem = useSignal<Problem | null>(null);
  useEffect(() => {
    get<Files>("/api/files").then(
      (found) => (files.value = found),
      (error) => (problem.value = asProblem(error)),
    );
  }, []);
  if (problem.value) return <ProblemWords problem={problem.value} />;
  if (!files.value) return <Waiting words="Looking into the folder" isBusy />;
  return (
    <div class="open">
      <p class="lead">{files.value.folder}</p>
      <div class="open-lists">
        <FileList
          title="Readings"
          names={files.value.measurements}
          now={state.value?.measurements?.name ?? ""}
          onOpen={openReadings}
        />
        <FileList title="Cells" names={files.value.cells} now={cell.value?.file ?? ""} onOpen={openCell} />
      </div>
      <Projects files={files.value} />
      <div class="open-foot">
        <label class="button">
          Files of your own …
          <input
            class="hidden"
            type="file"
            accept=".csv,.txt,.tsv,.asc,text/csv,text/plain"
            multiple
            onChange={(event) => {
              const files = [...(event.currentTarget.files ?? [])];
              if (files.length > 0) void loadFiles(files);
            }}
          />
        </label>
        <span class="muted">or drop them on the page: also a log of joints and a tracker's points together</span>
        <a href="/api/export/template.csv" download="template.csv">
          An empty table
        </a>
      </div>
      <PracticeForm />
    </div>
  );
}

/** Projects of the folder, and sessions that are kept of themselves; nothing where there is neither. */
function Projects({files}: {files: Files}) {
  if (files.projects.length + files.recent.length === 0) return null;
  return (
    <div class="open-lists">
      <FileList title="Projects" names={files.projects} now={state.value?.project?.file ?? ""} onOpen={openProject} />
      <section>
        <h2>Recent</h2>
        <ul class="files">
          {files.recent.map((session) => (
            <li key={session.file}>
              <button class="file" title={session.file} onClick={() => openRecent(session.file, session.cell)}>
                {session.cell}
                <small class="muted">
                  {" "}
                  {session.readings || "no readings"} · {plural(Number(session.models), "model")} ·{" "}
                  {whenText(session.saved)}
                </small>
              </button>
            </li>
          ))}
        </ul>
      </section>
    </div>
  );
}

function whenText(saved: string): string {
  const when = new Date(saved);
  return Number.isNaN(when.getTime()) ? "" : when.toLocaleString("en-GB", {dateStyle: "short", timeStyle: "short"});
}

function FileList({
  title,
  names,
  now,
  onOpen,
}: {
  title: string;
  names: string[];
  now: string;
  onOpen: (name: string) => void;
}) {
  return (
    <section>
      <h2>{title}</h2>
      {names.length === 0 ? (
        <p class="muted">none in this folder</p>
      ) : (
        <ul class="files">
          {names.map((name) => (
            <li key={name}>
              <button class="file" aria-current={name === now || undefined} onClick={() => onOpen(name)}>
                {name}
              </button>
            </li>
          ))}
        </ul>
      )}
    </section>
  );
}
