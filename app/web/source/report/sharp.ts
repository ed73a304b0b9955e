// Imported before any drawing: canvases of a report have at least two pixels per pixel of the page, so that they are
// sharp on paper.
const ratio = Math.max(2, devicePixelRatio || 1);
Object.defineProperty(window, "devicePixelRatio", {get: () => ratio});
