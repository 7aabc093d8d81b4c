// Links to parts of the lab. They scroll without changing the address, whose # part holds the set-up.

export function followAnchors(): void {
  document.addEventListener("click", (event) => {
    if (event.ctrlKey || event.metaKey || event.shiftKey || event.altKey) return;
    const link = (event.target as Element).closest<HTMLAnchorElement>('a[href^="#"]');
    const part = link && document.getElementById(link.hash.slice(1));
    // The essay's scenes, and the lab as a whole, have addresses.
    if (!part || part.id === "lab" || !part.closest("#lab")) return;
    event.preventDefault();
    part.scrollIntoView();
    // The next Tab key continues from there.
    part.focus({ preventScroll: true });
  });
}
