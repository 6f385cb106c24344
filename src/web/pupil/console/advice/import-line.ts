import type { Reference } from '#reference/meaning';
import { importsIn } from '#python/imports';
import { childrenOf, type PythonText, type SyntaxNode } from '#python/tree';

/** An import that a program lacks. */
export interface Lacking {
  readonly module: string;
  readonly code: string;
}

/** Robots' modules: those of the chosen robot, and all of them. */
export interface RobotModules {
  readonly own: readonly string[];
  readonly all: ReadonlySet<string>;
}

/** Modules that programs take everything from. */
const WHOLE = ['calliopemini', 'microbit'];

/**
 * The import that gives a name on the chosen board and robot: of the module itself, of the board's, of the robot's, or
 * of the only module that has it. `null` where several could be meant, or none.
 */
export function importLine(name: string, reference: Reference, { own, all }: RobotModules): Lacking | null {
  const modules = reference.importable();
  const has = (module: string): boolean => modules.get(module)?.().names().has(name) ?? false;
  if (modules.has(name) && (!all.has(name) || own.includes(name))) return { module: name, code: `import ${name}` };
  const whole = [...WHOLE.filter((it) => modules.has(it)), ...own].find(has);
  if (whole !== undefined) return { module: whole, code: `from ${whole} import *` };
  const others = Array.from(modules.keys()).filter((it) => !all.has(it) && !it.startsWith('u') && has(it));
  const [only] = others;
  return only !== undefined && others.length === 1 ? { module: only, code: `from ${only} import ${name}` } : null;
}

/**
 * The program with an import more: below its others, or below its first comment and text, above all that it does. An
 * import of everything goes above imports of single names.
 */
export function withImport(program: PythonText, code: string): string {
  const { text } = program;
  const statements = childrenOf(program.tree.topNode).filter(({ name }) => name !== 'Comment');
  const start = isText(statements[0]) ? 1 : 0;
  const first = statements.slice(start);
  const end = first.findIndex(({ name }) => name !== 'ImportStatement');
  const imports = first.slice(0, end < 0 ? undefined : end);
  // Everything of a module, put below, would win over single names that were imported on purpose.
  const singles = imports.some((it) => importsIn(program, it).some(({ symbol }) => symbol !== null && symbol !== '*'));
  const above = code.endsWith('*') && singles ? imports[0] : undefined;
  const last = above === undefined ? (imports.at(-1) ?? (start === 1 ? statements[0] : undefined)) : undefined;
  if (last !== undefined) {
    const lineEnd = text.indexOf('\n', last.to);
    return lineEnd < 0 ? `${text}\n${code}\n` : `${text.slice(0, lineEnd + 1)}${code}\n${text.slice(lineEnd + 1)}`;
  }
  const place = above?.from ?? first[0]?.from ?? text.length;
  const at = text.lastIndexOf('\n', place - 1) + 1;
  return `${text.slice(0, at)}${code}\n${text.slice(at)}`;
}

const isText = (statement: SyntaxNode | undefined): boolean =>
  statement?.name === 'ExpressionStatement' && statement.firstChild?.name === 'String';
