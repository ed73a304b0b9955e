// Imported before anything is drawn: canvases of a report have at least two pixels per page pixel, so that they are
// sharp on paper.
const ratio = Math.max(2, devicePixelRatio || 1);
Object.defineProperty(window, "devicePixelRatio", {get: () => ratio});
