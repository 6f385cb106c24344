/** The folder of the pictures of the handbook. */
export const PICTURES: string;

/** The name of the picture of a place in a language. */
export function pictureName(place: string, language: string): string;

/** Takes all pictures anew. */
export function takePictures(
  open: (language: string) => Promise<import('@playwright/test').BrowserContext>,
  url: string,
  languages: readonly string[],
): Promise<void>;
