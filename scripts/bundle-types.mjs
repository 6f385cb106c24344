// The types of a package in one file: a module's exports and everything they consist of, without any import.
import { readFileSync } from 'node:fs';
import { dirname, join, resolve } from 'node:path';
import ts from 'typescript';
import { Failure, root } from './progress.mjs';

/**
 * Gathers the types of a module. What nobody can reach from its exports is left out; two types of the same name keep
 * apart.
 *
 * @param {string} entry absolute path of the module
 * @returns {string} a declaration file that imports nothing
 * @throws Failure when a type is somebody else's, or cannot be told from its own module alone
 */
export function bundleTypes(entry) {
  const modules = new Modules();
  const start = modules.at(entry);
  const exported = modules.exportsOf(start);
  const reached = reach(
    modules,
    [...exported.values()].map(({ target }) => target),
    start.globals,
  );
  const names = namesFor(exported, reached);
  const texts = [...reached.declared.values()].map((one) => printed(one, names));
  const globals = start.globals.map((node) => printed({ module: start, nodes: [node], links: reached.links }, names));
  return `${[...texts, ...globals, exportList(exported, names)].join('\n\n')}\n`;
}

/** Identifies a declaration: the same text for the same one. */
const keyOf = ({ module, name }) => `${module.path}\0${name}`;

/** Follows everything that the declarations mention. */
function reach(modules, targets, globals) {
  const declared = new Map();
  const links = new Map();
  const foreign = new Set();
  const waiting = [...targets];
  const follow = (module, node) => {
    for (const identifier of mentioned(node)) {
      const target = modules.find(module, identifier.text);
      links.set(identifier, target);
      if (target === null) foreign.add(identifier.text);
      else waiting.push(target);
    }
  };
  for (const node of globals) follow(modules.at(node.getSourceFile().fileName), node);
  for (let target = waiting.shift(); target; target = waiting.shift()) {
    const { module, name } = target;
    if (declared.has(keyOf(target))) continue;
    if (module.unclear.has(name)) throw new Failure(`The type of ${name} in ${module.path} must be written there.`);
    const nodes = module.declarations.get(name);
    declared.set(keyOf(target), { ...target, nodes, links });
    for (const node of nodes) follow(module, node);
  }
  return { declared, links, foreign };
}

/** The names under which things are known in the one file: exports keep theirs, and none takes the place of a browser's. */
function namesFor(exported, { declared, foreign }) {
  const names = new Map();
  const taken = new Set(foreign);
  const give = (target, wanted) => {
    if (names.has(keyOf(target))) return;
    let name = wanted;
    for (let number = 1; taken.has(name); number += 1) name = `${wanted}_${number}`;
    taken.add(name);
    names.set(keyOf(target), name);
  };
  for (const [name, { target }] of exported) give(target, name);
  for (const one of declared.values()) give(one, one.name);
  return names;
}

/** A declaration for the one file: with its last comment, its names as given, not exported by itself. */
function printed({ module, nodes, links }, names) {
  return nodes
    .map((node) => {
      const from = node.jsDoc?.at(-1)?.pos ?? node.getStart();
      const edits = mentioned(node)
        .filter((identifier) => links.get(identifier))
        .map((identifier) => ({ at: identifier, text: names.get(keyOf(links.get(identifier))), isWord: false }));
      for (const name of declaredNames(node))
        edits.push({ at: name, text: names.get(keyOf({ module, name: name.text })), isWord: false });
      const marks = node.modifiers?.filter(({ kind }) => kind === ts.SyntaxKind.ExportKeyword) ?? [];
      for (const at of marks) edits.push({ at, text: '', isWord: true });
      return edited(module.text, from, node.end, edits);
    })
    .join('\n');
}

function edited(text, from, end, edits) {
  let done = '';
  let place = from;
  for (const { at, text: instead, isWord } of edits.sort((a, b) => a.at.getStart() - b.at.getStart())) {
    done += text.slice(place, at.getStart()) + instead;
    place = isWord ? at.end + 1 : at.end; // a keyword goes with the space behind it
  }
  return done + text.slice(place, end);
}

function exportList(exported, names) {
  const list = (isType) =>
    [...exported]
      .filter(([, it]) => it.isType === isType)
      .map(([name, { target }]) => {
        const inside = names.get(keyOf(target));
        return inside === name ? name : `${inside} as ${name}`;
      })
      .sort();
  const line = (word, all) => (all.length === 0 ? [] : [`${word} { ${all.join(', ')} };`]);
  return [...line('export', list(false)), ...line('export type', list(true))].join('\n') || 'export {};';
}

/** Identifiers in a declaration that mean another one. */
function mentioned(node) {
  const found = [];
  const note = (name) => {
    let first = name;
    while (!ts.isIdentifier(first)) first = ts.isQualifiedName(first) ? first.left : first.expression;
    found.push(first);
  };
  const visit = (at) => {
    if (ts.isTypeReferenceNode(at)) note(at.typeName);
    else if (ts.isExpressionWithTypeArguments(at)) note(at.expression);
    else if (ts.isTypeQueryNode(at)) note(at.exprName);
    else if (ts.isImportTypeNode(at)) throw new Failure(`import(…) within a type: ${at.getText()}`);
    ts.forEachChild(at, visit);
  };
  visit(node);
  return found;
}

/** The names that a statement declares. */
function declaredNames(node) {
  if (ts.isVariableStatement(node))
    return node.declarationList.declarations.map(({ name }) => name).filter(ts.isIdentifier);
  const isNamed =
    ts.isInterfaceDeclaration(node) ||
    ts.isTypeAliasDeclaration(node) ||
    ts.isClassDeclaration(node) ||
    ts.isFunctionDeclaration(node) ||
    ts.isEnumDeclaration(node);
  return isNamed && node.name !== undefined ? [node.name] : [];
}

const isValue = (node) => ts.isVariableStatement(node) || ts.isClassDeclaration(node) || ts.isFunctionDeclaration(node);

/** The modules of `src`, each read when it is needed. */
class Modules {
  read = new Map();

  at(path) {
    const known = this.read.get(path) ?? readModule(path);
    this.read.set(path, known);
    return known;
  }

  /** The declaration that a name refers to within a module; `null`: none of ours. */
  find(module, name) {
    if (module.declarations.has(name)) return { module, name };
    const imported = module.imports.get(name);
    return imported === undefined ? null : this.exported(this.at(imported.from), imported.name);
  }

  /** The declaration that a module exports under a name. */
  exported(module, name) {
    const found = this.exportsOf(module).get(name);
    if (found === undefined) throw new Failure(`${module.path} exports no ${name}.`);
    return found.target;
  }

  /** Everything that a module exports: name → what it is, and whether it is there at run time. */
  exportsOf(module) {
    const all = new Map();
    for (const { from, isType } of module.stars)
      for (const [name, one] of this.exportsOf(this.at(from))) all.set(name, { ...one, isType: isType || one.isType });
    for (const { name, local, from, isType } of module.exports) {
      const target = from === null ? this.find(module, local) : this.exported(this.at(from), local);
      if (target === null) throw new Failure(`${module.path} exports ${local}, which is not its own.`);
      const hasValue = target.module.declarations.get(target.name).some(isValue);
      all.set(name, { target, isType: isType || !hasValue });
    }
    return all;
  }
}

function readModule(path) {
  const source = readFileSync(path, 'utf8');
  const { outputText: text, diagnostics = [] } = ts.transpileDeclaration(source, {
    fileName: path,
    reportDiagnostics: true,
    compilerOptions: { target: ts.ScriptTarget.ES2022, strict: true, declaration: true },
  });
  const module = {
    path,
    text,
    declarations: new Map(),
    imports: new Map(),
    exports: [],
    stars: [],
    globals: [],
    unclear: unclearNames(path, source, diagnostics),
  };
  const file = ts.createSourceFile(path, text, ts.ScriptTarget.ES2022, true);
  for (const node of file.statements) readStatement(module, node);
  return module;
}

function readStatement(module, node) {
  if (ts.isImportDeclaration(node)) readImport(module, node);
  else if (ts.isExportDeclaration(node)) readExport(module, node);
  else if (ts.isModuleDeclaration(node) && node.name.text === 'global') module.globals.push(node);
  for (const { text: name } of declaredNames(node)) {
    module.declarations.set(name, [...(module.declarations.get(name) ?? []), node]);
    const isExported = node.modifiers?.some(({ kind }) => kind === ts.SyntaxKind.ExportKeyword) ?? false;
    if (isExported) module.exports.push({ name, local: name, from: null, isType: false });
  }
}

function readImport(module, node) {
  const { importClause, moduleSpecifier } = node;
  const bindings = importClause?.namedBindings;
  if (bindings === undefined || !ts.isNamedImports(bindings)) return;
  for (const { name, propertyName } of bindings.elements)
    module.imports.set(name.text, {
      get from() {
        return pathOf(moduleSpecifier.text, module.path);
      },
      name: (propertyName ?? name).text,
    });
}

function readExport(module, node) {
  const { exportClause, moduleSpecifier, isTypeOnly: isType } = node;
  const from = moduleSpecifier === undefined ? null : pathOf(moduleSpecifier.text, module.path);
  if (exportClause === undefined) module.stars.push({ from, isType });
  else
    for (const { name, propertyName, isTypeOnly } of exportClause.elements)
      module.exports.push({ name: name.text, local: (propertyName ?? name).text, from, isType: isType || isTypeOnly });
}

/** The file behind what an import says. */
function pathOf(specifier, importer) {
  if (specifier.startsWith('#')) return join(root, 'src', `${specifier.slice(1)}.ts`);
  if (specifier.startsWith('.')) return `${resolve(dirname(importer), specifier)}.ts`;
  throw new Failure(`${importer} has types from ${specifier}: whoever installs the package has none.`);
}

/** Exports whose types would have to be worked out from other modules. */
function unclearNames(path, source, diagnostics) {
  if (diagnostics.length === 0) return new Set();
  const file = ts.createSourceFile(path, source, ts.ScriptTarget.ES2022, true);
  const within = ({ start = 0 }) => file.statements.filter((node) => node.pos <= start && start < node.end);
  return new Set(
    diagnostics
      .flatMap(within)
      .flatMap(declaredNames)
      .map(({ text }) => text),
  );
}
