import type { Language } from '#core/languages';
import { escaped } from './escaped';

/**
 * A page as one HTML file that needs nothing else.
 *
 * @param body ready HTML
 */
export const pageOf = (title: string, styles: string, language: Language, body: string): string => `<!doctype html>
<html lang="${language}">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>${escaped(title)}</title>
<style>${styles}</style>
</head>
<body>
${body}
</body>
</html>
`;
