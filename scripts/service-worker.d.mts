export function buildServiceWorker(folder?: string): Promise<{ readonly count: number; readonly bytes: number }>;
