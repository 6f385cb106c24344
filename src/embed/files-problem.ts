import { FILE_BYTES, MAIN, nameProblem, projectLimits, utf8Bytes, type SourceFile } from '#project/project';

import type { Refusal } from './simulator';

/** Why files of a host cannot be the program, in one sentence, for every dialect; `null` if they can. */
export function filesProblem(files: readonly SourceFile[]): Refusal {
  // First, because the following code compares each with each.
  if (files.length > projectLimits.files)
    return `files: there are ${files.length}; the limit is ${projectLimits.files}.`;
  for (const [index, { name, text }] of files.entries()) {
    const others = files.filter((_, other) => other !== index);
    const problem = nameProblem(name, others);
    if (problem !== null) return `files.${index}.name: "${shown(name)}" cannot be the name of a file (${problem}).`;
    // A project with a longer file could be saved but not opened again.
    if (utf8Bytes(text) > FILE_BYTES)
      return `files.${index}.text: "${name}" has ${utf8Bytes(text)} bytes; the limit is ${FILE_BYTES}.`;
  }
  return files.some(({ name }) => name === MAIN) ? null : `files: ${MAIN} is missing.`;
}

const shown = (name: string): string => (name.length > 60 ? `${name.slice(0, 60)}…` : name);
