// Dialog for opening: readings and cells of the folder, a file of the user, or simulated readings for practice.
import {plural} from "../../../drawing/numbers.js";
import {useAnswer} from "../server/answers";
import {cell, state} from "../server/workbench";
import {Dialog} from "./dialog";
import {loadFiles, openCell, openProject, openReadings, openRecent} from "./load";
import {PracticeForm} from "./practice_form";
import {ProblemWords, Waiting} from "./states";

interface Files {
  folder: string;
  cells: string[];
  measurements: string[];
  projects: string[];
  recent: RecentSession[];
}

/** Session in the state folder, kept automatically or renamed. */
interface RecentSession {
  file: string;
  cell: string;
  readings: string;
  models: string;
  saved: string;
}

export function OpenDialog() {
  return (
    <Dialog name="open" title="Open">
      <OpenBody />
    </Dialog>
  );
}

function OpenBody() {
  const {document: files, problem} = useAnswer<Files>("/api/files");
  if (problem) return <ProblemWords problem={problem} />;
  if (!files) return <Waiting words="Reading the folder" isBusy />;
  return (
    <div class="open">
      <p class="lead">{files.folder}</p>
      <div class="open-lists">
        <FileList
          title="Readings"
          names={files.measurements}
          now={state.value?.measurements?.name ?? ""}
          onOpen={openReadings}
        />
        <FileList title="Cells" names={files.cells} now={cell.value?.file ?? ""} onOpen={openCell} />
      </div>
      <Projects files={files} />
      <div class="open-foot">
        <label class="button">
          Browse …
          <input
            class="hidden"
            type="file"
            accept=".csv,.txt,.tsv,.asc,.urdf,.xml,text/csv,text/plain"
            multiple
            onChange={(event) => {
              const files = [...(event.currentTarget.files ?? [])];
              if (files.length > 0) void loadFiles(files);
            }}
          />
        </label>
        <span class="muted">
          or drop them on the page: also a log of joints and a tracker's points together, or a robot as URDF
        </span>
        <a href="/api/export/template.csv" download="template.csv">
          An empty table
        </a>
      </div>
      <PracticeForm />
    </div>
  );
}

/** Projects in the folder and automatically kept sessions; empty if there are none. */
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

interface FileListProps {
  title: string;
  names: string[];
  now: string;
  onOpen: (name: string) => void;
}

function FileList({title, names, now, onOpen}: FileListProps) {
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
