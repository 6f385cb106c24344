import { keyword } from '../table';
import type { Names } from '../types';

const WORDS = [
  'and',
  'as',
  'assert',
  'break',
  'class',
  'continue',
  'def',
  'del',
  'elif',
  'else',
  'except',
  'False',
  'finally',
  'for',
  'from',
  'global',
  'if',
  'import',
  'in',
  'is',
  'lambda',
  'None',
  'nonlocal',
  'not',
  'or',
  'pass',
  'raise',
  'return',
  'True',
  'try',
  'while',
  'with',
  'yield',
] as const;

/** The words of the language that programs for the boards need; `async` and `await` are left out. */
export const keywords: Names = Object.fromEntries(WORDS.map((word) => [word, keyword()]));
