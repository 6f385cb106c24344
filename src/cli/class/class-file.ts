import { existsSync } from 'node:fs';
import { basename } from 'node:path';
import { stemOf } from '#intake/formats';
import { classToText, parseClass } from '#school-class/class-file';
import { classLimits, newClass, type SchoolClass } from '#school-class/school-class';
import { withoutReload } from '../check/series-task';
import { readLimited } from '../read-files';
import { reasonOf } from '../reason-of';
import { writeOutput } from '../write-output';

/** A class as it is afterwards, and what there is to say; or what is wrong. */
export type Done = { readonly schoolClass: SchoolClass; readonly said: readonly string[] } | Problem;

type Problem = { readonly problem: string };

/** The class in a file. */
export function readClass(path: string): SchoolClass | Problem {
  const file = readLimited(path, classLimits.characters);
  if ('problem' in file) return file;
  const parsed = parseClass(file.text);
  return 'problem' in parsed ? { problem: withoutReload(`${path}: ${parsed.problem}`) } : parsed.schoolClass;
}

/** The class in a file; where there is none, a new one that is called like it. */
export const readOrNewClass = (path: string): SchoolClass | Problem =>
  existsSync(path) ? readClass(path) : newClass(stemOf(basename(path)));

/** Writes the file of a class. The old one stays until the new one is whole. @returns what is wrong; `null`: nothing */
export function writeClass(path: string, schoolClass: SchoolClass): string | null {
  try {
    writeOutput(path, classToText(schoolClass));
    return null;
  } catch (error) {
    return `${path}: ${reasonOf(error)}`;
  }
}
