export function buildServiceWorker(folder: string): Promise<void>;
export function bareServiceWorker(): Promise<import('vite').Rolldown.OutputChunk>;
