import { shown } from '#scene/problem';
import type { Reader } from '#scene/reader';

import type { ProjectProblem } from './problem';
import { FILE_BYTES, MAIN, nameProblem, projectLimits, utf8Bytes, type SourceFile } from './project';

/** The files, and what is wrong with their names and sizes. */
export function readFiles(
  value: unknown,
  at: string,
  reader: Reader,
): { files: readonly SourceFile[]; problems: ProjectProblem[] } {
  const entries = reader.list(value, at, { min: 1, max: projectLimits.files });
  const files: SourceFile[] = [];
  const problems: ProjectProblem[] = [];
  for (const [index, entry] of entries.entries()) {
    const path = `${at}[${String(index)}]`;
    const fields = reader.fields(entry, path, ['name', 'text']);
    const name = reader.text(fields['name'], `${path}.name`, projectLimits.textCharacters);
    const text = reader.text(fields['text'], `${path}.text`, projectLimits.textCharacters);
    if (typeof fields['name'] === 'string' && typeof fields['text'] === 'string')
      problems.push(...fileProblems({ name, text }, files, path));
    files.push({ name, text });
  }
  return { files, problems };
}

/** The faults of a file that comes after `before`. */
function fileProblems(file: SourceFile, before: readonly SourceFile[], path: string): ProjectProblem[] {
  const { name, text } = file;
  const wrong = nameProblem(name, before);
  const bytes = utf8Bytes(text);
  const problems: ProjectProblem[] = [];
  if (wrong !== null) {
    const message = `${path}.name: ${shown(name)} cannot be the name of a file: ${NAME_RULES[wrong]}`;
    problems.push({ code: 'file-name', path: `${path}.name`, value: shown(name), params: { rule: wrong }, message });
  } else if (before.length === 0 && name !== MAIN) {
    const message = `${path}.name: the first file must be ${MAIN}, not ${shown(name)}.`;
    problems.push({ code: 'no-main', path: `${path}.name`, value: shown(name), params: {}, message });
  }
  if (bytes > FILE_BYTES) {
    const message = `${path}.text: ${String(bytes)} bytes are too many; the limit is ${String(FILE_BYTES)}.`;
    const params = { length: bytes, max: FILE_BYTES };
    problems.push({ code: 'file-too-large', path: `${path}.text`, value: '', params, message });
  }
  return problems;
}

const NAME_RULES = {
  nameEmpty: 'it is empty.',
  nameTaken: 'another file has it.',
  nameCharacters: 'it may have letters, digits, "_", "-" and "." only.',
  nameLong: 'it is too long.',
} as const;
