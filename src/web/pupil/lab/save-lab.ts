/** Marks of an element that its stylesheet gives, as a picture of its own needs them. */
const STYLES = ['fill', 'stroke', 'stroke-width', 'stroke-dasharray', 'font', 'text-anchor'] as const;
/** Pixels of the picture for a px of the page. */
const FINE = 2;

/** A drawing of the page as a document of its own, in the colours that it has now. */
function documentOf(svg: SVGSVGElement, ground: string): string {
  const copy = svg.cloneNode(true) as SVGSVGElement;
  const [from, to] = [svg, copy].map((one) => [...one.querySelectorAll<SVGElement>('*')]);
  for (const [place, element] of (to ?? []).entries()) {
    const source = from?.[place];
    if (source === undefined) continue;
    const style = getComputedStyle(source);
    for (const name of STYLES) element.style.setProperty(name, style.getPropertyValue(name));
  }
  copy.setAttribute('xmlns', 'http://www.w3.org/2000/svg');
  copy.style.background = ground;
  return new XMLSerializer().serializeToString(copy);
}

/** A drawing of the page as a picture (PNG). @returns `null`: the browser cannot make it */
export async function pictureOf(svg: SVGSVGElement): Promise<Blob | null> {
  const { width, height } = svg.getBoundingClientRect();
  const ground = getComputedStyle(document.documentElement).getPropertyValue('--surface').trim();
  const image = new Image();
  const text = documentOf(svg, ground);
  await new Promise((done, fail) => {
    image.onload = done;
    image.onerror = fail;
    image.src = `data:image/svg+xml;charset=utf-8,${encodeURIComponent(text)}`;
  });
  const canvas = document.createElement('canvas');
  [canvas.width, canvas.height] = [Math.round(width * FINE), Math.round(height * FINE)];
  const context = canvas.getContext('2d');
  if (context === null) return null;
  context.fillStyle = ground;
  context.fillRect(0, 0, canvas.width, canvas.height);
  context.drawImage(image, 0, 0, canvas.width, canvas.height);
  return new Promise((done) => canvas.toBlob(done, 'image/png'));
}
