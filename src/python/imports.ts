import { childrenOf, parsePython, readPython, splitBy, textOf, type PythonText, type SyntaxNode } from './tree';

/** One imported name. */
export interface Import {
  /** The module as written: `math`, `os.path`, `.drive`; `.` for `from . import x`. */
  readonly module: string;
  /** The module's name in the syntax tree. */
  readonly moduleNode: SyntaxNode | null;
  /** The name imported from the module; `*` for all names, `null` for the module itself. */
  readonly symbol: string | null;
  readonly symbolNode: SyntaxNode | null;
  /** Its name in the program; `null` for `*`. */
  readonly nameNode: SyntaxNode | null;
}

/** The names that an ImportStatement imports. */
export function importsIn(source: PythonText, statement: SyntaxNode): readonly Import[] {
  const children = childrenOf(statement).filter(({ name }) => !['(', ')', 'Comment', '⚠'].includes(name));
  const split = children.findIndex(({ name }) => name === 'import');
  const path = children[0]?.name === 'from' ? children.slice(1, split < 0 ? undefined : split) : null;
  const module = path?.map((it) => textOf(source, it)).join('') ?? null;
  const moduleNode = path?.find(({ name }) => name === 'VariableName') ?? null;
  return splitBy(split < 0 ? [] : children.slice(split + 1), ',').flatMap((part) => {
    const [first] = part;
    if (first === undefined) return [];
    const as = part.findIndex(({ name }) => name === 'as');
    const named = part.slice(0, as < 0 ? undefined : as);
    const text = named.map((it) => textOf(source, it)).join('');
    const given = as < 0 ? first : (part[as + 1] ?? first);
    const nameNode = given.name === 'VariableName' ? given : null;
    return module === null
      ? { module: text, moduleNode: first, symbol: null, symbolNode: null, nameNode }
      : { module, moduleNode, symbol: text, symbolNode: first, nameNode };
  });
}

const known = new WeakMap<PythonText, readonly string[]>();

/**
 * The modules that a program imports, by the first part of their names, even while they are being typed. Files beside it
 * (`from .drive import go`) do not count.
 */
export function importedModules(text: string): readonly string[] {
  const source = readPython(text);
  const before = known.get(source);
  if (before !== undefined) return before;
  // A quote or bracket left open may have swallowed lines below it: there each line that looks like an import counts.
  const lines = source.hasErrors ? (text.match(/^[ \t]*(from|import)\b.*/gm) ?? []) : [];
  const found = [source, ...lines.map((line) => parsePython(line.trimStart()))].flatMap(modulesIn);
  const modules = Array.from(new Set(found));
  known.set(source, modules);
  return modules;
}

function modulesIn(source: PythonText): readonly string[] {
  const modules: string[] = [];
  source.tree.iterate({
    enter: (ref) => {
      if (ref.name === 'ImportStatement') modules.push(...moduleNames(source, ref.node));
    },
  });
  return modules;
}

/** `from mbrobot` names a module even before its `import` is typed. */
function moduleNames(source: PythonText, statement: SyntaxNode): readonly string[] {
  const { firstChild: first } = statement;
  const module = first?.name === 'from' ? first.nextSibling : null;
  if (first?.name === 'from') return module?.name === 'VariableName' ? [textOf(source, module)] : [];
  return importsIn(source, statement).map(({ module: path }) => path.split('.')[0] ?? '');
}

/** The modules that the programs of a project import. Files whose name does not end in `.py` are not programs. */
export function modulesImportedBy(files: Readonly<Record<string, string>>): ReadonlySet<string> {
  const programs = Object.entries(files).filter(([name]) => name.endsWith('.py'));
  return new Set(programs.flatMap(([, text]) => importedModules(text)));
}

/** The same without the project's own files. */
export function foreignModules(files: Readonly<Record<string, string>>): ReadonlySet<string> {
  return new Set(Array.from(modulesImportedBy(files)).filter((name) => !(`${name}.py` in files)));
}

/** Both: with the project's own files, and without them. */
export const importsOf = (files: Readonly<Record<string, string>>) => ({
  all: modulesImportedBy(files),
  foreign: foreignModules(files),
});
