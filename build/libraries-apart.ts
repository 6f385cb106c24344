/** Parts a library that is one module: what only late parts of the page use becomes a module of its own. */
import { readFile } from 'node:fs/promises';

import { parseSync, type Plugin } from 'vite';

/** Behind the name of a library: its late half. */
export const LATE_HALF = '?late-half';

type Program = ReturnType<typeof parseSync>['program'];
type Statement = Program['body'][number];

/** The two halves of a module. */
export interface Halves {
  readonly first: string;
  readonly late: string;
}

/**
 * Lets imports of the late names ask for the library's late half.
 *
 * @param libraries the late names of each library
 */
export function librariesApart(libraries: Readonly<Record<string, readonly string[]>>): Plugin {
  /** The halves of a file, for both are asked for. */
  const files = new Map<string, { readonly library: string; readonly late: readonly string[] }>();
  return {
    name: 'libraries-apart',
    apply: 'build',
    enforce: 'pre',
    async resolveId(id, importer) {
      const library = id.replace(LATE_HALF, '');
      const late = libraries[library];
      if (late === undefined) return null;
      const found = await this.resolve(library, importer, { skipSelf: true });
      if (found === null) return null;
      files.set(found.id, { library, late });
      return id === library ? found : { ...found, id: found.id + LATE_HALF };
    },
    async load(id) {
      const file = id.replace(LATE_HALF, '');
      const parted = files.get(file);
      if (parted === undefined) return null;
      const { first, late } = halvesOf(await readFile(file, 'utf8'), parted.library, parted.late);
      return { code: id === file ? first : late, moduleSideEffects: false };
    },
    transform: {
      order: 'post',
      handler(code) {
        let apart = code;
        for (const [library, late] of Object.entries(libraries)) apart = withLateImports(apart, library, late);
        return apart === code ? null : { code: apart, map: null };
      },
    },
  };
}

/** The code with its imports of late names from the library's late half. */
export function withLateImports(code: string, library: string, late: readonly string[]): string {
  const imports = new RegExp(String.raw`\bimport\s*\{([^}]*)\}\s*from\s*["']${library}["'];?`, 'g');
  return code.replace(imports, (whole, list: string) => {
    const names = list.split(',').map((name) => name.trim());
    const isLate = (name: string): boolean => late.includes(name.split(/\s/)[0] ?? '');
    if (!names.some(isLate)) return whole;
    const of = (wanted: readonly string[], from: string): string => `import { ${wanted.join(', ')} } from '${from}';`;
    const early = names.filter((name) => !isLate(name));
    return `${of(early, library)} ${of(names.filter(isLate), library + LATE_HALF)}`;
  });
}

/**
 * Parts a module: its late half has the late names, and all that nothing else in the module needs.
 *
 * @throws {Error} if the late half would assign to a variable of the first half, which modules cannot
 */
export function halvesOf(code: string, library: string, late: readonly string[]): Halves {
  const exported = exportsOf(code);
  const unknown = late.filter((name) => !exported.has(name));
  if (unknown.length > 0) throw new Error(`${library} has no ${unknown.join(', ')}.`);
  const pieces = piecesOf(code);
  const makers = new Map(pieces.flatMap((piece) => piece.names.map((name) => [name, piece] as const)));
  const made = (names: readonly string[]): Piece[] => names.flatMap((name) => makers.get(name) ?? []);
  const isLateName = (name: string): boolean => late.includes(name);
  const early = [...exported].filter(([name]) => !isLateName(name)).map(([, local]) => local);
  const needed = reached([...pieces.filter(({ names }) => names.length === 0), ...made(early)], made);
  const lateOnes = pieces.filter((piece) => !piece.isImport && !needed.has(piece));
  const used = reached(lateOnes, made);
  const shared = [...used].filter((piece) => !piece.isImport && needed.has(piece)).flatMap(({ names }) => names);
  const mentioned = new Set(lateOnes.flatMap((piece) => piece.mentioned));
  const lent = shared.filter((name) => mentioned.has(name));
  const assigned = lateOnes.flatMap((piece) => piece.assigned).filter((name) => lent.includes(name));
  if (assigned.length > 0) throw new Error(`The late half of ${library} assigns to ${assigned.join(', ')}.`);
  const imports = pieces.filter(({ isImport, names }) => isImport && names.some((name) => mentioned.has(name)));
  const exports = (isOwn: (name: string) => boolean): string[] =>
    [...exported].filter(([name]) => isOwn(name)).map(([name, local]) => `${local} as ${name}`);
  return {
    first: [
      ...pieces.filter((piece) => needed.has(piece)).map(({ text }) => text),
      listed('export', [...exports((name) => !isLateName(name)), ...lent.map((name) => `${name} as $${name}`)]),
    ].join('\n'),
    late: [
      ...imports.map(({ text }) => text),
      `${listed(
        'import',
        lent.map((name) => `$${name} as ${name}`),
      )} from '${library}';`,
      ...lateOnes.map(({ text }) => text),
      listed('export', exports(isLateName)),
    ].join('\n'),
  };
}

const listed = (word: string, names: readonly string[]): string => `${word} { ${names.join(', ')} }`;

/** A statement of a module. */
interface Piece {
  readonly text: string;
  /** The names that it makes for others; none: it does something. */
  readonly names: readonly string[];
  /** Names that it may use, also its own. */
  readonly mentioned: readonly string[];
  readonly assigned: readonly string[];
  readonly isImport: boolean;
}

function piecesOf(code: string): readonly Piece[] {
  const { body } = parseSync('module.js', code).program;
  return body
    .filter((statement) => !statement.type.startsWith('Export'))
    .map((statement) => ({
      text: code.slice(statement.start, statement.end),
      names: madeBy(statement),
      ...namesIn(statement),
      isImport: statement.type === 'ImportDeclaration',
    }));
}

/** The names of a module for others, each with that inside. All are in lists: `export { one, other as another }`. */
function exportsOf(code: string): ReadonlyMap<string, string> {
  const names = new Map<string, string>();
  for (const statement of parseSync('module.js', code).program.body) {
    if (!statement.type.startsWith('Export')) continue;
    if (statement.type !== 'ExportNamedDeclaration' || statement.declaration !== null || statement.source !== null)
      throw new Error('Only modules with lists of exports can be parted.');
    for (const { exported, local } of statement.specifiers) names.set(nameOf(exported), nameOf(local));
  }
  return names;
}

const nameOf = (node: object): string => ('name' in node ? String(node.name) : '');

function madeBy(statement: Statement): string[] {
  if (statement.type === 'ImportDeclaration') return statement.specifiers.map(({ local }) => local.name);
  if (statement.type === 'FunctionDeclaration' || statement.type === 'ClassDeclaration')
    return statement.id === null ? [] : [statement.id.name];
  return statement.type === 'VariableDeclaration'
    ? statement.declarations.flatMap(({ id }) => namesIn(id).mentioned)
    : [];
}

/** All names in a part of the code, and those that it assigns to. */
function namesIn(part: object): { readonly mentioned: string[]; readonly assigned: string[] } {
  const [mentioned, assigned] = [new Set<string>(), new Set<string>()];
  const look = (node: unknown): void => {
    if (Array.isArray(node)) return node.forEach(look);
    if (typeof node !== 'object' || node === null) return;
    const { type, name, left, argument, computed, property, key, ...rest } = node as Readonly<Record<string, unknown>>;
    if (type === 'Identifier') mentioned.add(String(name));
    const target = type === 'AssignmentExpression' ? left : type === 'UpdateExpression' ? argument : null;
    if (target !== null && (target as { type?: string }).type === 'Identifier') assigned.add(nameOf(target as object));
    // The names of properties mean nothing outside.
    look([left, argument, computed === false ? null : [property, key], Object.values(rest)]);
  };
  look(part);
  return { mentioned: [...mentioned], assigned: [...assigned] };
}

/** All that some pieces need, themselves included. */
function reached(from: readonly Piece[], made: (names: readonly string[]) => readonly Piece[]): ReadonlySet<Piece> {
  const all = new Set(from);
  for (const piece of all) for (const next of made(piece.mentioned)) all.add(next);
  return all;
}
