// Tables of a job's record, as docs/outage.md describes them.
#pragma once

namespace tubeplan::app {

inline constexpr int kJobFormat = 1;  ///< format of the record; a record of another format is refused

/// Statements that create the tables. The log is append-only: triggers of the database reject changes.
inline constexpr const char* kJobSchema = R"(
CREATE TABLE job (key TEXT PRIMARY KEY, value TEXT NOT NULL) WITHOUT ROWID;
CREATE TABLE sheet (
  generator TEXT NOT NULL, leg TEXT NOT NULL, cell TEXT NOT NULL, mirrored INTEGER NOT NULL, fingerprint TEXT NOT NULL,
  pitch_m REAL NOT NULL, PRIMARY KEY (generator, leg)) WITHOUT ROWID;
CREATE TABLE tube (
  generator TEXT NOT NULL, leg TEXT NOT NULL, tube_row INTEGER NOT NULL, tube_column INTEGER NOT NULL,
  x_m REAL NOT NULL, y_m REAL NOT NULL, state TEXT NOT NULL,
  PRIMARY KEY (generator, leg, tube_row, tube_column),
  FOREIGN KEY (generator, leg) REFERENCES sheet (generator, leg)) WITHOUT ROWID;
CREATE TABLE package (id INTEGER PRIMARY KEY, name TEXT NOT NULL UNIQUE);
CREATE TABLE list (
  package INTEGER NOT NULL REFERENCES package (id), generator TEXT NOT NULL, leg TEXT NOT NULL, content TEXT NOT NULL,
  PRIMARY KEY (package, generator, leg)) WITHOUT ROWID;
CREATE TABLE item (
  id INTEGER PRIMARY KEY, package INTEGER NOT NULL REFERENCES package (id),
  generator TEXT NOT NULL, leg TEXT NOT NULL, tube_row INTEGER NOT NULL, tube_column INTEGER NOT NULL,
  excluded TEXT NOT NULL, place INTEGER, unreachable TEXT NOT NULL DEFAULT '',
  UNIQUE (package, generator, leg, tube_row, tube_column),
  FOREIGN KEY (generator, leg, tube_row, tube_column) REFERENCES tube (generator, leg, tube_row, tube_column));
CREATE INDEX item_tube ON item (generator, leg, tube_row, tube_column);
CREATE TABLE event (
  id INTEGER PRIMARY KEY AUTOINCREMENT, at TEXT NOT NULL, who TEXT NOT NULL CHECK (who <> ''), kind TEXT NOT NULL,
  item INTEGER NOT NULL REFERENCES item (id), value TEXT NOT NULL, method TEXT NOT NULL, reason TEXT NOT NULL,
  undoes INTEGER UNIQUE REFERENCES event (id));
CREATE INDEX event_item ON event (item, kind, id);
CREATE TRIGGER event_stays BEFORE UPDATE ON event BEGIN SELECT RAISE(ABORT, 'the log is append-only'); END;
CREATE TRIGGER event_remains BEFORE DELETE ON event BEGIN SELECT RAISE(ABORT, 'the log is append-only'); END;
CREATE TRIGGER item_remains BEFORE DELETE ON item BEGIN SELECT RAISE(ABORT, 'items are never removed'); END;
CREATE VIEW standing AS
  SELECT item.*, package.name AS package_name,
    (SELECT mark.value FROM event AS mark
      WHERE mark.item = item.id AND mark.kind = 'mark'
        AND NOT EXISTS (SELECT 1 FROM event AS undo WHERE undo.undoes = mark.id)
      ORDER BY mark.id DESC LIMIT 1) AS mark,
    (SELECT MAX(id) FROM event WHERE event.item = item.id) AS last_event
  FROM item JOIN package ON package.id = item.package;
)";

}  // namespace tubeplan::app
