/** First words of a docstring that says nothing yet about what a thing is or does. */
const EMPTY = /^\*\s*(?:\*\s*)?(What|Where|Who|Whoever|So|Of)\b/;

/**
 * A rule for ESLint: a docstring says what a thing is (“The pulses of a channel, in µs”) or does (“Reads …”).
 *
 * @type {import('eslint').Rule.RuleModule}
 */
export const docstringWords = {
  meta: {
    type: 'suggestion',
    schema: [],
    messages: { empty: 'A docstring says what a thing is or does; “{{word}} …” is half a sentence.' },
  },
  create: ({ sourceCode, report }) => ({
    Program() {
      for (const comment of sourceCode.getAllComments()) {
        const [, word] = (comment.type === 'Block' && EMPTY.exec(comment.value)) || [];
        if (word !== undefined && comment.loc) report({ loc: comment.loc, messageId: 'empty', data: { word } });
      }
    },
  }),
};
