/** In the place of parts of jsPDF that the app does not use (see `vite.config.ts`): nothing. */
export {};
