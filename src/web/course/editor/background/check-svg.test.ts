import { describe, expect, it } from 'vitest';
import { svgProblem, svgSize } from './check-svg';

const NS = 'xmlns="http://www.w3.org/2000/svg" xmlns:xlink="http://www.w3.org/1999/xlink"';
const svg = (inside: string, start = ''): string => `${start}<svg ${NS} viewBox="0 0 400 300">${inside}</svg>`;

describe('an SVG as background', () => {
  it('may be a plain drawing, as Inkscape and Illustrator write it', () => {
    const start = '<?xml version="1.0" encoding="UTF-8"?>\n<!-- Created with Inkscape -->\n';
    const doctype =
      '<!DOCTYPE svg PUBLIC "-//W3C//DTD SVG 1.1//EN" "http://www.w3.org/Graphics/SVG/1.1/DTD/svg11.dtd">';
    const drawing =
      '<defs><linearGradient id="a"/><path id="p" d="M0 0h9"/></defs><use xlink:href="#p"/>' +
      '<rect fill="url(#a)" style="fill:url(#a);stroke:#000" width="9" height="9"/><style>.a{fill:red}</style>' +
      '<image href="data:image/png;base64,AAAA"/><text>Konto: onkel = 3</text>';
    expect(svgProblem(svg(drawing, start))).toBeNull();
    expect(svgProblem(svg(drawing, start + doctype))).toBeNull();
  });

  it('must be one: other texts are refused as such', () => {
    expect(svgProblem('<html><body><svg></svg></body></html>')).toBe('no-svg');
    expect(svgProblem('print("hi")')).toBe('no-svg');
    expect(svgProblem('')).toBe('no-svg');
  });

  it.each([
    ['a script', '<script>alert(1)</script>'],
    ['a script in another name space', '<x:ScRiPt xmlns:x="http://www.w3.org/2000/svg">1</x:ScRiPt>'],
    ['what happens on an event', '<rect onload="alert(1)"/>'],
    ['what happens on an event, without a space before', '<rect id="a"onclick=\'a()\'/>'],
    ['foreign elements', '<foreignObject><body xmlns="http://www.w3.org/1999/xhtml"/></foreignObject>'],
    ['a picture from elsewhere', '<image href="https://example.org/a.png"/>'],
    ['a picture from elsewhere, with its address in disguise', '<image href="&#104;ttps://example.org/a.png"/>'],
    ['another drawing inside', '<image href="data:image/svg+xml;base64,AAAA"/>'],
    ['a part of another file', '<use xlink:href="other.svg#a"/>'],
    ['a link that runs a script', '<a href="javascript:alert(1)"/>'],
    ['a colour from elsewhere', '<rect fill="url(https://example.org/#a)"/>'],
    ['a style from elsewhere', '<style>@import "https://example.org/a.css";</style>'],
    ['a style from elsewhere, in disguise', '<style>@\\69mport "a.css";</style>'],
    ['a font from elsewhere', '<style>@font-face{src:url("https://example.org/f.woff")}</style>'],
    ['an animation', '<rect><animate attributeName="x" to="9"/></rect>'],
    ['a change by itself', '<rect><set attributeName="href" to="x"/></rect>'],
  ])('must not contain %s', (_, inside) => {
    expect(svgProblem(svg(inside))).toBe('unsafe');
  });

  it('must not define entities that grow, nor fetch its style', () => {
    expect(svgProblem(svg('&b;', '<!DOCTYPE svg [<!ENTITY a "x"><!ENTITY b "&a;&a;">]>'))).toBe('unsafe');
    expect(svgProblem(svg('', '<?xml version="1.0"?><?xml-stylesheet href="a.css"?>'))).toBe('unsafe');
  });
});

describe('the check of an SVG', () => {
  it('needs no longer for a file that is made to hold it up', () => {
    expect(svgProblem('<!-- -->'.repeat(200_000))).toBe('no-svg');
    expect(svgProblem(svg('url('.repeat(200_000)))).toBe('unsafe');
    expect(svgProblem(svg('<a href="'.repeat(200_000)))).toBe('unsafe');
  });
});

describe('the size of an SVG', () => {
  it('is that of its viewBox, else its width and height', () => {
    expect(svgSize('<svg viewBox="0 0 400 300" width="10mm" height="10mm">')).toEqual({ width: 400, height: 300 });
    expect(svgSize("<svg width='120mm' height='90mm'>")).toEqual({ width: 120, height: 90 });
  });

  it('is unknown with percentages and nonsense', () => {
    expect(svgSize('<svg width="100%" height="100%">')).toBeNull();
    expect(svgSize('<svg viewBox="0 0 -4 NaN">')).toBeNull();
    expect(svgSize('<svg>')).toBeNull();
  });
});
