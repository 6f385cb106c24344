import { argumentsOf, attributeOf, type Argument } from '#python/expressions';
import { textOf, type SyntaxNode } from '#python/tree';

import type { Context, Visitors } from '../context';
import { newerNames } from '../newer-names';

/** String and bytes methods that the device lacks, and names that only newer firmware has. */
export const attributeVisitors: Visitors = {
  CallExpression(node, context) {
    const attribute = node.firstChild === null ? null : attributeOf(node.firstChild);
    if (attribute === null) return;
    const name = textOf(context.file, attribute.property);
    if (context.isOwnAttribute(name)) return;
    const method = METHODS.get(name);
    if (method === undefined || !method.fits(attribute.owner, context)) return;
    const owner = textOf(context.file, attribute.owner);
    const [first] = argumentsOf(context.file, node);
    const value = textOfValue(first, context);
    const instead = method.instead(/[\r\n]/.test(owner) || owner.length > 30 ? 'text' : owner, value);
    context.report({ node: attribute.property, rule: method.rule, name, instead });
  },
  MemberExpression(node, context) {
    const attribute = attributeOf(node);
    if (attribute === null) return;
    const name = textOf(context.file, attribute.property);
    const newer = newerNames.get(name);
    if (newer === undefined || context.device.features.includes(newer.feature) || context.isOwnAttribute(name)) return;
    const owner = textOf(context.file, attribute.owner).split('.');
    const [root] = owner;
    const last = owner.at(-1);
    if (root === undefined || last === undefined || !newer.owner.test(last) || !isFromOutside(root, context)) return;
    context.report({ node: attribute.property, rule: 'newer-name', name: `${last}.${name}` });
  },
};

const textOfValue = (argument: Argument | undefined, { file }: Context): string =>
  argument?.value ? textOf(file, argument.value) : '';

interface Method {
  readonly rule: 'text-method' | 'bytes-hex' | 'bytes-fromhex';
  fits(owner: SyntaxNode, context: Context): boolean;
  instead(owner: string, argument: string): string;
}

/** True if a value is a text or may be one: nothing else in a program has such a method, unless it is imported. */
const textOrUnknown = (owner: SyntaxNode, context: Context): boolean =>
  ['text', 'bytes', 'array', 'unknown'].includes(context.kindOf(owner)) && !isImported(owner, context);

const METHODS = new Map<string, Method>(
  Object.entries<Method>({
    splitlines: { rule: 'text-method', fits: textOrUnknown, instead: (owner) => `${owner}.split("\\n")` },
    partition: {
      rule: 'text-method',
      fits: textOrUnknown,
      instead: (owner, separator) => `${owner}.split(${separator}, 1)`,
    },
    rpartition: {
      rule: 'text-method',
      fits: textOrUnknown,
      instead: (owner, separator) => `${owner}.rsplit(${separator}, 1)`,
    },
    center: {
      rule: 'text-method',
      fits: (owner, context) => ['text', 'bytes', 'array'].includes(context.kindOf(owner)), // servos have a center() too
      instead: (owner, width) => `"{:^${/^\d+$/.test(width) ? width : '20'}}".format(${owner})`,
    },
    hex: {
      rule: 'bytes-hex',
      fits: textOrUnknown,
      instead: (owner) => `"".join("{:02x}".format(b) for b in ${owner})`,
    },
    fromhex: {
      rule: 'bytes-fromhex',
      fits: (owner, context) =>
        /^(bytes|bytearray)$/.test(textOf(context.file, owner)) || ['bytes', 'array'].includes(context.kindOf(owner)),
      instead: (_owner, text) => {
        const name = /^\w+$/.test(text) ? text : 'text';
        return `bytes([int(${name}[i:i + 2], 16) for i in range(0, len(${name}), 2)])`;
      },
    },
  }),
);

/** True for a module, or something that comes from one: the program's text does not show what it can do. */
function isImported(node: SyntaxNode, context: Context): boolean {
  if (node.name === 'CallExpression') return false;
  if (node.name !== 'VariableName') return false;
  return (context.names.bindings.get(textOf(context.file, node)) ?? []).some(
    (it) => it.kind === 'import' || (it.kind === 'value' && it.of === 'itself' && makesImported(it.node, context)),
  );
}

/** True for `Servo(pin0)` and `servo.Servo(pin0)` of a library. */
function makesImported(value: SyntaxNode, context: Context): boolean {
  const called = value.name === 'CallExpression' ? value.firstChild : null;
  if (called === null) return false;
  const root = textOf(context.file, called).split('.', 1)[0] ?? '';
  const bound = context.names.bindings.get(root) ?? [];
  return bound.some(({ kind }) => kind === 'import') && /(^|\.)[A-Z]\w*$/.test(textOf(context.file, called));
}

/** True if a name is not the pupil's own: it comes from an import. */
function isFromOutside(name: string, context: Context): boolean {
  const bound = context.names.bindings.get(name);
  if (bound !== undefined) return bound.every(({ kind }) => kind === 'import');
  return context.names.imports.some(({ symbol }) => symbol === '*');
}
