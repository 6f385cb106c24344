/**
 * ESLint's `max-lines-per-function` for classes: counts lines of code, so that nobody saves a docstring to pass.
 *
 * @type {import('eslint').Rule.RuleModule}
 */
export const classLines = {
  meta: {
    type: 'suggestion',
    schema: [{ type: 'integer', minimum: 1 }],
    messages: {
      tooLong:
        'Class {{name}} has {{lines}} lines of code, at most {{most}} are allowed: give a part of it a class of its own.',
    },
  },
  create(context) {
    const [most] = context.options;
    const { sourceCode } = context;
    const check = (node) => {
      const lines = linesOfCode(sourceCode, node);
      if (lines > most)
        context.report({
          node: node.id ?? node,
          messageId: 'tooLong',
          data: { name: node.id?.name ?? 'without a name', lines, most },
        });
    };
    return { ClassDeclaration: check, ClassExpression: check };
  },
};

/** Lines on which something other than a comment stands. */
function linesOfCode(sourceCode, node) {
  const lines = new Set();
  for (const { loc } of sourceCode.getTokens(node))
    for (let line = loc.start.line; line <= loc.end.line; line += 1) lines.add(line);
  return lines.size;
}
