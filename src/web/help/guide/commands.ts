import type { ReferenceContext } from '#reference/context';
import { Reference, type Meaning } from '#reference/meaning';

/** A command that a program can give, as the help lists it. */
export interface Command {
  /** The module it comes from: `mbrobot`. */
  readonly module: string;
  /** Its name after `from … import *`: `forward`, `irLeft.read_digital`. */
  readonly name: string;
  /** Its arguments as the reference names them, one text for each form of the call: `(radius: float)`. */
  readonly calls: readonly string[];
  /** The code to insert into a program: `leftArc(radius)`. */
  readonly code: string;
  /** Name of its words in the reference. */
  readonly text: string;
}

/**
 * The commands of a module, in the order of the reference: its functions, and the functions of the objects it has.
 * Commands that several objects share (all pins, both buttons) are listed once, with the first of them.
 *
 * @param name of the module; one that does not exist has no commands
 */
export function commandsOf(name: string, context: ReferenceContext): readonly Command[] {
  const module = new Reference(context).module(name);
  const seen = new Set<string>();
  const commands = [...(module?.names() ?? [])].flatMap(([label, meaning]) => commandsAt(name, label, meaning()));
  return commands.filter(({ text }) => !seen.has(text) && seen.add(text));
}

function commandsAt(module: string, name: string, meaning: Meaning): readonly Command[] {
  const { kind, missing } = meaning.item;
  if (missing !== null || name.startsWith('_')) return [];
  if (kind === 'function') return [commandOf(module, name, meaning)];
  if (kind !== 'object' && kind !== 'value') return [];
  return [...meaning.names()].flatMap(([member, inner]) => {
    const { item } = inner();
    const isCommand = item.kind === 'function' && item.missing === null && !member.startsWith('_');
    return isCommand ? [commandOf(module, `${name}.${member}`, inner())] : [];
  });
}

function commandOf(module: string, name: string, { item: { calls, text } }: Meaning): Command {
  const shown = calls.map((call) => call.replace(/ -> .*$/, ''));
  return { module, name, calls: shown, code: `${name}(${neededArguments(calls[0] ?? '()')})`, text: text ?? name };
}

/** The names of the arguments that must be given: `(text: str, delay: int = 150, *, wait: bool = True)` → `text`. */
function neededArguments(call: string): string {
  const names: string[] = [];
  for (const part of partsOf(call)) {
    if (part.startsWith('*')) break;
    if (part !== '/' && !part.includes('=')) names.push(part.replace(/:.*$/, '').trim());
  }
  return names.join(', ');
}

/** The parts between the outer brackets, split at their own commas. */
function partsOf(call: string): readonly string[] {
  const parts: string[] = [];
  let [depth, part] = [0, ''];
  for (const character of call) {
    if (character === '(' || character === '[') depth += 1;
    if (character === ')' || character === ']') depth -= 1;
    if (depth === 0) break;
    if (depth === 1 && (character === ',' || (character === '(' && part === ''))) {
      parts.push(part);
      part = '';
    } else part += character;
  }
  return [...parts, part].map((it) => it.trim()).filter(Boolean);
}
