export function buildServiceWorker(folder?: string): Promise<{ readonly count: number; readonly bytes: number }>;
export function bareServiceWorker(): Promise<import('vite').Rolldown.OutputChunk>;
