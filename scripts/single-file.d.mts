import type { FrameCheckParts } from './frame-check.mjs';

export function inlineScript(code: string): string;
export function inlineComment(text: string): string;
export function inlineStyle(css: string): string;
export function singleFile(
  html: string,
  parts: {
    readonly script: string;
    readonly css: string;
    readonly icon: string;
    readonly licences: string;
    readonly check: FrameCheckParts;
  },
): string;
