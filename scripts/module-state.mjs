const message =
  'A module of the page remembers nothing: give what changes to the models of a room (kit/part.ts, kit/state/late-models.ts), ' +
  'and what is always made the same to core/memo.ts.';

const declared = ['Program > VariableDeclaration', 'Program > ExportNamedDeclaration > VariableDeclaration'];
/** A name that is declared at the top, and is not said to be read-only. */
const open =
  ":not([id.typeAnnotation.typeAnnotation.typeName.name=/^Readonly/]):not([id.typeAnnotation.typeAnnotation.operator='readonly'])";
const held = [
  'NewExpression[callee.name=/^(Weak)?(Map|Set)$/][arguments.length=0]',
  'CallExpression[callee.name=/^(shallowRef|ref|reactive|shallowReactive|effectScope)$/]',
  'ArrayExpression[elements.length=0]',
  'ObjectExpression[properties.length=0]',
];

/** For ESLint's `no-restricted-syntax`: state that outlives a page, and the test that made it. */
export const moduleState = declared.flatMap((at) => [
  { selector: `${at}[kind='let']`, message },
  ...held.map((what) => ({ selector: `${at} > VariableDeclarator${open} > ${what}.init`, message })),
]);
