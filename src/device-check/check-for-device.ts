import { namesOf, type ProgramNames } from '#python/scopes';
import { readPython, type PythonText } from '#python/tree';
import type { Context, Mark, Visitor, Visitors } from './context';
import type { Device, Finding } from './finding';
import { Kinds } from './kinds';
import { endOnLine, placeOf } from './lines';
import { ruleOf } from './rule-table';
import { attributeVisitors } from './visitors/attributes';
import { builtinVisitors } from './visitors/builtins';
import { classVisitors } from './visitors/classes';
import { moduleVisitors } from './visitors/modules';
import { sequenceVisitors } from './visitors/sequences';
import { textVisitors } from './visitors/text';
import { timerVisitors } from './visitors/timers';

/** All rules by the node they look at. */
const visitors = gather([
  ...[textVisitors, builtinVisitors, attributeVisitors],
  ...[classVisitors, moduleVisitors, sequenceVisitors, timerVisitors],
]);

interface Program {
  readonly name: string;
  readonly file: PythonText;
  readonly names: ProgramNames;
}

/**
 * Finds what runs here and not on the device: syntax, functions, methods and modules that its firmware lacks. It reads
 * the text only; nothing is run, and no run depends on it. In doubt it says nothing: what a pupil's own files define
 * is theirs, whatever its name.
 *
 * @param files the program's files by their names; those that do not end in `.py` are no programs
 * @returns findings in the order of the files and their lines
 */
export function checkForDevice(files: Readonly<Record<string, string>>, device: Device): readonly Finding[] {
  const programs = Object.entries(files).filter(([name]) => name.endsWith('.py'));
  const read = programs.map(([name, text]): Program => {
    const file = readPython(text);
    return { name, file, names: namesOf(file) };
  });
  return read.flatMap((one) => checkFile(one, read, device));
}

function checkFile(one: Program, all: readonly Program[], device: Device): readonly Finding[] {
  const marks: Mark[] = [];
  const context = contextOf(one, all, device, marks);
  one.file.tree.iterate({
    enter: ({ name, node }) => {
      if (name === 'TypeDef') return false; // a type hint: the device reads it and never looks at it (py/compile.c)
      for (const visit of visitors.get(name) ?? []) visit(node, context);
      return true;
    },
  });
  return marks
    .filter(({ rule }) => isLacking(rule, device))
    .map((mark) => findingOf(mark, one))
    .sort((a, b) => a.from - b.from);
}

function contextOf(one: Program, all: readonly Program[], device: Device, marks: Mark[]): Context {
  const kinds = new Kinds(one.file, one.names);
  const modules = new Set(all.map(({ name }) => name.slice(0, -'.py'.length)));
  const starred = one.names.imports.filter(({ symbol, module }) => symbol === '*' && modules.has(module));
  const isBound = ({ names }: Program, name: string): boolean => names.bindings.has(name);
  return {
    file: one.file,
    names: one.names,
    device,
    kindOf: (node) => kinds.of(node),
    isOwnAttribute: (name) => all.some(({ names }) => names.attributes.has(name)),
    isOwnName: (name) =>
      isBound(one, name) || (starred.length > 0 && all.some((file) => file !== one && isBound(file, name))),
    isOwnModule: (name) => modules.has(name),
    report: (mark) => marks.push(mark),
  };
}

/** True if the device lacks what the rule is about: always, unless it came with a MicroPython that the device has. */
function isLacking(rule: Mark['rule'], { micropython: [major, minor] }: Device): boolean {
  const { since } = ruleOf(rule);
  return since === undefined || major < since[0] || (major === since[0] && minor < since[1]);
}

function findingOf(
  { node, rule, name = '', instead = '', severity }: Mark,
  { name: file, file: { text } }: Program,
): Finding {
  const { line, column } = placeOf(text, node.from);
  const to = endOnLine(text, node.from, node.to);
  return { file, line, column, from: node.from, to, rule, name, instead, severity: severity ?? ruleOf(rule).severity };
}

function gather(groups: readonly Visitors[]): ReadonlyMap<string, readonly Visitor[]> {
  const all = new Map<string, Visitor[]>();
  for (const [name, visit] of groups.flatMap((group) => Object.entries(group))) {
    const known = all.get(name);
    if (known === undefined) all.set(name, [visit]);
    else known.push(visit);
  }
  return all;
}
