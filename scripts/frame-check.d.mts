/** The parts of what a page says where it cannot start (`frame-check.mjs`). */
export interface FrameCheckParts {
  readonly script: string;
  readonly css: string;
  readonly html: string;
}
export function frameCheckParts(): Promise<FrameCheckParts>;
export function scriptHash(script: string): string;
export function withFrameCheck(page: string, parts: FrameCheckParts): string;
export function withSingleCheck(page: string, parts: FrameCheckParts): string;
