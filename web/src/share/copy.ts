// Copies a text to the clipboard, or selects it for the visitor to copy if that is not allowed.

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
  if (place instanceof HTMLInputElement || place instanceof HTMLTextAreaElement) place.select();
  else getSelection()?.selectAllChildren(place);
}
