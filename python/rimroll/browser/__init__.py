"""The lab in a browser or a notebook.

`setup` writes what is computed in Python as the set-up of the page, `setup_check` checks a set-up,
`built_page` finds the page and makes one file of it, `server` serves it and `view` shows it.
"""
