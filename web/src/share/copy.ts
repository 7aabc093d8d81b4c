// Text to the clipboard, or where there is none to be had, selected for the visitor to copy.

export async function copyText(text: string, shownIn: HTMLElement): Promise<boolean> {
  try {
    await navigator.clipboard.writeText(text);
    return true;
  } catch {
    select(shownIn);
    return false;
  }
}

function select(place: HTMLElement): void {
  const details = place.closest("details");
  if (details) details.open = true;
  place.focus();
  if (place instanceof HTMLInputElement) place.select();
  else getSelection()?.selectAllChildren(place);
}
