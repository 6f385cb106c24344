/** The parts of the check for frames (`frame-check.mjs`). */
export interface FrameCheckParts {
  readonly script: string;
  readonly css: string;
  readonly html: string;
}
export function frameCheckParts(): Promise<FrameCheckParts>;
export function scriptHash(script: string): string;
export function withFrameCheck(page: string, parts: FrameCheckParts): string;
