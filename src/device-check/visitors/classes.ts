import { attributeOf } from '#python/expressions';
import { childrenOf, parentsOf, textOf, type SyntaxNode } from '#python/tree';

import type { Visitors } from '../context';

/** Operator methods that the device never calls, each with a name for an ordinary method instead. */
const SPECIAL = new Map(Object.entries({
  mul: 'times', truediv: 'divide', floordiv: 'divide', mod: 'remainder', divmod: 'divide', pow: 'power',
  matmul: 'times', and: 'both', or: 'either', xor: 'differ', lshift: 'shift_left', rshift: 'shift_right',
  neg: 'negative', pos: 'positive', invert: 'inverse', abs: 'length', float: 'to_float', complex: 'to_complex',
})); // prettier-ignore

const REVERSE = [
  'radd', 'rsub', 'rmul', 'rtruediv', 'rfloordiv', 'rmod', 'rpow', 'rmatmul', 'rand', 'ror', 'rxor', 'rlshift', 'rrshift',
]; // prettier-ignore

const DESCRIPTORS = ['get', 'set', 'delete', 'set_name'];

/** Special methods that the device never calls, and special attributes that it lacks. */
export const classVisitors: Visitors = {
  FunctionDefinition(node, context) {
    const name = node.getChild('VariableName');
    const method = name === null ? null : /^__([a-z_]+)__$/.exec(textOf(context.file, name));
    if (name === null || method?.[1] === undefined || !isInClass(node)) return;
    const [whole, word] = method;
    const special = SPECIAL.get(word);
    if (special !== undefined) context.report({ node: name, rule: 'special-method', name: whole, instead: special });
    else if (REVERSE.includes(word)) context.report({ node: name, rule: 'reverse-method', name: whole });
    else if (word === 'setattr' || word === 'delattr') {
      context.report({ node: name, rule: 'attribute-hook', name: whole });
    } else if (DESCRIPTORS.includes(word)) context.report({ node: name, rule: 'descriptor', name: whole });
  },
  MemberExpression(node, context) {
    const attribute = attributeOf(node);
    if (attribute?.owner.name !== 'VariableName') return;
    const { owner, property } = attribute;
    const name = textOf(context.file, property);
    if (name === '__setattr__' || name === '__delattr__') {
      if (textOf(context.file, owner) === 'object' && !context.isOwnName('object'))
        context.report({ node: property, rule: 'attribute-hook', name });
    } else if (name === '__name__' || name === '__globals__') {
      if (isFunction(textOf(context.file, owner), context.file.tree.topNode, context.file.text)) {
        context.report({ node: property, rule: 'function-attribute', name });
      }
    } else if (/^(start|stop|step|indices)$/.test(name) && isIndexOf(owner, context.file.text)) {
      context.report({ node: property, rule: 'slice-attribute', name });
    }
  },
};

function isInClass(definition: SyntaxNode): boolean {
  const around = definition.parent?.name === 'DecoratedStatement' ? definition.parent.parent : definition.parent;
  return around?.name === 'Body' && around.parent?.name === 'ClassDefinition';
}

/** Whether the file has functions of this name, but no class or variable. */
function isFunction(name: string, top: SyntaxNode, text: string): boolean {
  let functions = 0;
  let others = 0;
  top.cursor().iterate(({ name: type, node }) => {
    if (type !== 'VariableName' || text.slice(node.from, node.to) !== name) return;
    const parent = node.parent?.name;
    if (parent === 'FunctionDefinition') functions += 1;
    else if (parent === 'ClassDefinition' || parent === 'ParamList' || node.nextSibling?.name === 'AssignOp')
      others += 1;
  });
  return functions > 0 && others === 0;
}

/** True if a name is the index of the `__getitem__` that it stands in. */
function isIndexOf(node: SyntaxNode, text: string): boolean {
  for (const parent of parentsOf(node)) {
    if (parent.name !== 'FunctionDefinition') continue;
    const name = parent.getChild('VariableName');
    if (name === null || !/^__(get|set|del)item__$/.test(text.slice(name.from, name.to))) return false;
    const [, index] = childrenOf(parent.getChild('ParamList') ?? parent).filter((it) => it.name === 'VariableName');
    return index !== undefined && text.slice(index.from, index.to) === text.slice(node.from, node.to);
  }
  return false;
}
