import { namesOf, type Binding } from '#python/scopes';
import { parsePython, textOf, type SyntaxNode } from '#python/tree';
import { hashOfText } from '#tape/result';
import { isTooDeep } from './depth';
import type { Files } from './facts';

/**
 * A fingerprint that programs have in common which differ only in the names that they give, in spaces and in comments.
 */
export function twinHash(files: Files): string {
  const programs = Object.keys(files).filter((name) => name.endsWith('.py')).sort(); // prettier-ignore
  const others = programs.filter((name) => name !== 'main.py');
  return hashOfText(['main.py', ...others].map((name) => shapeOf(files[name] ?? '')).join('\n'));
}

/** The same of the programs of all devices. */
export const twinOfAll = (programs: readonly Files[]): string =>
  programs.length === 1 ? twinHash(programs[0] ?? {}) : hashOfText(programs.map(twinHash).join('\n'));

/** The tree of a program as text, each name of its own replaced by the order of first occurrence. */
function shapeOf(text: string): string {
  const source = parsePython(text);
  if (isTooDeep(source)) return text;
  const { bindings, attributes } = namesOf(source);
  const numbers = new Map<string, number>();
  const parts: string[] = [];
  const nameOf = (name: string): string => {
    const bound = bindings.get(name) ?? [];
    const isOwn = attributes.has(name) || (bound.length > 0 && !bound.some((binding) => isImported(binding, name)));
    if (!isOwn) return name;
    const number = numbers.get(name) ?? numbers.size;
    numbers.set(name, number);
    return `#${String(number)}`;
  };
  const isName = ({ name }: SyntaxNode): boolean => name === 'VariableName' || name === 'PropertyName';
  const isOpen: boolean[] = [];
  source.tree.iterate({
    enter: ({ node, name }) => {
      if (name === 'Comment') return false;
      isOpen.push(node.firstChild !== null);
      if (node.firstChild !== null) parts.push(`${name}(`);
      else parts.push(isName(node) ? nameOf(textOf(source, node)) : textOf(source, node).trim());
      return true;
    },
    leave: ({ name }) => {
      if (name !== 'Comment' && isOpen.pop() === true) parts.push(')');
    },
  });
  return parts.join(' ');
}

/** True if it is imported under its own name: `from mbrobot import left` is another program than one with `right`. */
const isImported = (binding: Binding, name: string): boolean =>
  binding.kind === 'import' && (binding.symbol ?? binding.module) === name;
