// Puts the whole app into one HTML file that needs nothing beside it: for frames that may load nothing (decision 0018).
import { scriptHash, withSingleCheck } from './frame-check.mjs';

/** The single file's own policy: its one script by its hash, workers made from it, WebAssembly, and no network. */
const policyFor = (script) =>
  [
    "default-src 'none'",
    `script-src ${scriptHash(script)} 'wasm-unsafe-eval'`,
    "style-src 'unsafe-inline'",
    'img-src data: blob:',
    'worker-src blob:',
    "connect-src 'none'",
    "base-uri 'none'",
    "form-action 'none'",
  ].join('; ');

/**
 * Code as it may stand inside a script element: nothing in it ends the element, or begins a comment of the HTML inside which
 * the end of the element would not count. Both letters can only stand in texts and regular expressions of minified code.
 */
export const inlineScript = (code) => code.replace(/<(?=\/script)/gi, '\\x3C').replace(/<(?=script|!--)/gi, '\\x3C');

/** CSS in a form that may stand inside a style element. */
export const inlineStyle = (css) => css.replace(/<\/(?=style)/gi, '<\\/');

/** A text in a form that may stand inside a comment: nothing in it ends the comment. */
export const inlineComment = (text) => text.replace(/--(?=!?>)/g, '- -');

/**
 * The page with everything inside.
 *
 * @param {string} html the ordinary page
 * @param {{ script: string, css: string, icon: string, licences: string, check: import('./frame-check.d.mts').FrameCheckParts }} parts
 *   classic script, all styles, the icon as SVG, the licences of all of it, what it says where it cannot start
 * @throws Error where the page does not look as expected
 */
export function singleFile(html, { script, css, icon, licences, check }) {
  const code = `\n${inlineScript(script).replace(/\r\n?/g, '\n').trim()}\n`;
  let page = html;
  const put = (pattern, replacement) => {
    if (!pattern.test(page)) throw new Error(`The page has nothing like ${pattern}.`);
    page = page.replace(pattern, () => replacement);
  };
  put(
    /<meta\s+http-equiv="Content-Security-Policy"[^>]*>/,
    `<meta http-equiv="Content-Security-Policy" content="${policyFor(code)}" />`,
  );
  put(
    /<link rel="icon"[^>]*>/,
    `<link rel="icon" type="image/svg+xml" href="data:image/svg+xml,${encodeURIComponent(icon)}" />`,
  );
  put(/[ \t]*<script type="module"[^>]*><\/script>\n/, `    <style>${inlineStyle(css)}</style>\n`);
  put(/[ \t]*<\/body>/, `    <script>${code}</script>\n  </body>`);
  return `${withSingleCheck(page, check).trimEnd()}\n<!--\n${inlineComment(licences).trim()}\n-->\n`;
}
