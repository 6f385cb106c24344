const COMPOUND = /^(?:@|(?:if|while|for|try|with|def|class)(?![A-Za-z0-9_]))/;

/**
 * Whether the REPL asks for another line: an open bracket or triple quote, a backslash at the end, or a compound
 * statement without the blank line that ends it. Source: MicroPython py/repl.c, mp_repl_continue_with_input.
 */
export function wantsMore(input: string): boolean {
  if (input === '') return false;
  const open = scan(input);
  if (open.quote.length === 3) return true;
  if (open.isBracketOpen && open.quote === '') return true;
  if (input.endsWith('\\')) return true;
  return COMPOUND.test(input) && !input.endsWith('\n');
}

function scan(input: string): { readonly quote: string; readonly isBracketOpen: boolean } {
  const depth = { '(': 0, '[': 0, '{': 0 };
  let quote = '';
  for (let i = 0; i < input.length; i++) {
    const letter = input[i];
    if (letter === '"' || letter === "'") {
      const triple = letter.repeat(3);
      if ((quote === '' || quote === triple) && input.startsWith(triple, i)) {
        i += 2;
        quote = quote === '' ? triple : '';
      } else if (quote === '' || quote === letter) {
        quote = quote === '' ? letter : '';
      }
    } else if (letter === '\\' && quote !== '' && /['"\\]/.test(input[i + 1] ?? '')) {
      i++;
    } else if (quote === '') {
      if (letter === '(' || letter === '[' || letter === '{') depth[letter]++;
      if (letter === ')') depth['(']--;
      if (letter === ']') depth['[']--;
      if (letter === '}') depth['{']--;
    }
  }
  return { quote, isBracketOpen: Object.values(depth).some((count) => count > 0) };
}
