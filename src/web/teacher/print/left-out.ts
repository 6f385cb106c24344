/** An empty module that stands in for the parts of jsPDF that the app does not use (see `vite.config.ts`). */
export {};
