// Comes before whatever draws: canvases of a report have two pixels of theirs and more for one of the page, so that they
// are sharp on paper.
const ratio = Math.max(2, devicePixelRatio || 1);
Object.defineProperty(window, "devicePixelRatio", {get: () => ratio});
