// The page's links to its own parts. They leave the address alone: what is after its # is the set-up.

export function followAnchors(): void {
  document.addEventListener("click", (event) => {
    if (event.ctrlKey || event.metaKey || event.shiftKey || event.altKey) return;
    const link = (event.target as Element).closest<HTMLAnchorElement>('a[href^="#"]');
    const part = link && document.getElementById(link.hash.slice(1));
    if (!part) return;
    event.preventDefault();
    part.scrollIntoView();
    // The next Tab goes on from there.
    part.focus({ preventScroll: true });
  });
}
