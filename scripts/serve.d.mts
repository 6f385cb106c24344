export const PAGE_POLICY: string;
export const WORKER_POLICY: string;
export function headersFor(path: string): Readonly<Record<string, string>>;
export function serve(options?: {
  readonly folder?: string;
  readonly port?: number;
  readonly host?: string;
}): Promise<{ readonly url: string; readonly others: readonly string[]; close(): Promise<void> }>;
export function atWords(at: { readonly url: string; readonly others: readonly string[] }): string;
