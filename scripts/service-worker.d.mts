export function buildServiceWorker(folder: string, isKept?: (url: string) => boolean): Promise<void>;
export function bareServiceWorker(): Promise<import('vite').Rolldown.OutputChunk>;
