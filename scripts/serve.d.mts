import type { IncomingMessage } from 'node:http';

export const PAGE_POLICY: string;
export const WORKER_POLICY: string;
export function headersFor(path: string): Readonly<Record<string, string>>;
export function serve(options?: {
  readonly folder?: string;
  readonly port?: number;
  readonly host?: string;
  readonly lacks?: (request: IncomingMessage) => boolean;
}): Promise<{ readonly url: string; readonly others: readonly string[]; close(): Promise<void> }>;
export function atWords(at: { readonly url: string; readonly others: readonly string[] }): string;
